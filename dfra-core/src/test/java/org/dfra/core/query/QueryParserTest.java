package org.dfra.core.query;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Random;
import org.dfra.core.query.RandomQueries.EverythingAttributes;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class QueryParserTest {

  private static final int QUERIES = 20_000;

  private final QueryParser parser = new QueryParser(RandomQueries.VOCABULARY);

  @Test
  void readsWhatAQueryWrites() {
    long seed = System.nanoTime();
    RandomQueries queries = new RandomQueries(seed);
    for (int i = 0; i < QUERIES; i++) {
      ModuleQuery<? extends Module> query = queries.next();
      assertThat(parser.parse(query.toString()))
          .as("seed %d, query %d: %s", seed, i, query)
          .isEqualTo(query)
          .hasToString(query.toString());
    }
  }

  @Test
  void readsAllOfItInAnyOrder() {
    ModuleQuery<LocationSensor> wanted =
        ModuleQuery.of(LocationSensor.class)
            .where(SensorAttributes.class, "maxRate", Condition.atLeast(1))
            .where(GpsReceiverAttributes.class, "fixModes", Condition.contains("3D"))
            .robot("atrv1")
            .name("gps_front")
            .within(50, new GeoPosition(27.98, -82.45, 0));
    assertThat(
            parser.parse(
                "LocationSensor with SensorAttributes.maxRate >= 1 and"
                    + " GpsReceiverAttributes.fixModes contains \"3D\" on atrv1 named gps_front"
                    + " within 50 m of 27.98, -82.45"))
        .isEqualTo(wanted);
    assertThat(
            parser.parse(
                "location_sensor within 0.05km of 27.98° N, 82.45° W and on atrv1"
                    + " and named \"gps_front\" with sensor.max_rate≥1"
                    + " with gps_receiver.fixModes contains 3D"))
        .isEqualTo(wanted);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "SensorAttributes.maxRate",
        "Sensor.maxRate",
        "sensor.maxRate",
        "sensor.max_rate",
        "org.dfra.persona.SensorAttributes.maxRate"
      })
  void attributesHaveShortNames(String name) {
    assertThat(parser.parse("GPSSensor with " + name + " from 0.5 to 10"))
        .isEqualTo(
            ModuleQuery.of(GPSSensor.class)
                .where(SensorAttributes.class, "maxRate", Condition.between(0.5, 10)));
  }

  @Test
  void valuesAreReadByTheirComponentsType() {
    assertThat(parser.parse("Module with module.state = ready and module.clients <= 2"))
        .isEqualTo(
            ModuleQuery.of(Module.class)
                .where(ModuleAttributes.class, "state", Condition.equalTo(Readiness.READY))
                .where(ModuleAttributes.class, "clients", Condition.atMost(2)));
    assertThat(parser.parse("Module with everything.texts = [b, \"a c\"] and everything.text = x"))
        .isEqualTo(
            ModuleQuery.of(Module.class)
                .where(EverythingAttributes.class, "texts", Condition.equalTo(List.of("b", "a c")))
                .where(EverythingAttributes.class, "text", Condition.equalTo("x")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "`` | at the end: a kind of module, such as GPSSensor, is expected here, not the end",
        "GPSSensr | at character 1: there is no kind of module \"GPSSensr\"; did you mean"
            + " \"GPSSensor\"?",
        "Toaster | at character 1: there is no kind of module \"Toaster\"; there is"
            + " AngularRateSensor, BatterySensor, Behavior, CameraSensor, Device, DriveEffector,"
            + " Effector, FlightEffector, FollowWaypoints, FuzzyDrive, GPSSensor, GoToWaypoint,"
            + " HeadingError, LocalGPSSensor, LocationSensor, MineDetector, Module, MotorSchema,"
            + " OdometrySensor, PanTiltEffector, PerceptualSchema, PositionEstimator, RangeFilter,"
            + " RangeSensor, RasterSearch, RecruitmentAgent, RecruitmentControl, ReturnHome,"
            + " Schema, Script, Sensor, TeamTracker, TimeSensor",
        "Sensor wiht x | at character 8: \"wiht\" begins no condition; did you mean \"with\"?",
        "Sensor near here | at character 8: \"near\" begins no condition; go on with named, on,"
            + " with or within",
        "Sensor on | at the end: the robot's name is expected here, not the end",
        "Sensor on a on b | at character 13: \"on\" occurs here a second time; leave one out",
        "Sensor with maxRate >= 1 | at character 13: \"maxRate\" is not an attribute; write one"
            + " with a dot, such as Sensor.maxRate",
        "Sensor with Senso.maxRate >= 1 | at character 13: there are no attributes \"Senso\"; did"
            + " you mean \"Sensor\"?",
        "Sensor with laser.maxRate >= 1 | at character 13: there are no attributes \"laser\";"
            + " there is Behavior, Camera, Chain, Drive, Effector, EmergencyStop, Everything, Flight,"
            + " GpsReceiver, Location, Module, MotorSchema, PanTilt, PerceptualSchema, Pose, Range,"
            + " Recruitment, Sensor",
        "Sensor with sensor.maxRat >= 1 | at character 13: SensorAttributes has no component"
            + " \"maxRat\"; did you mean \"maxRate\"?",
        "Sensor with sensor.volume >= 1 | at character 13: SensorAttributes has no component"
            + " \"volume\"; it has reading, modes, minRate, maxRate, power, preconditions",
        "Sensor with sensor.maxRate > 1 | at character 28: \">\" compares nothing; write >=, <=,"
            + " =, from … to or contains after SensorAttributes.maxRate",
        "Sensor with sensor.maxRate >= fast | at character 31: a number is expected here, not"
            + " \"fast\"",
        "Sensor with sensor.maxRate from 1 until 2 | at character 35: \"to\" is expected here, not"
            + " \"until\"",
        "Sensor with sensor.maxRate from 2 to 1 | at character 28: no number is at least 2.0 and at"
            + " most 1.0; exchange the two",
        "Sensor with sensor.reading >= 1 | at character 28: SensorAttributes.reading is a String"
            + " and has no range; only numbers do",
        "Sensor with module.state = redy | at character 28: \"redy\" is not a value of Readiness;"
            + " did you mean \"READY\"?",
        "Sensor with module.created = today | at character 30: \"today\" is not an instant in UTC;"
            + " write it like 2026-11-21T12:00:00Z",
        "Sensor with gps_receiver.fixModes = 3D | at character 37: a list is expected here, such as"
            + " [\"2D\", \"3D\"], not \"3D\"",
        "Sensor with sensor.reading = \"Gps | at character 30: the quotation mark is never closed;"
            + " write \"…\"",
        "Sensor within 50 of 1, 2 | at character 18: \"m\" is expected here, not \"of\"",
        "Sensor within 50 m of 91, 2 | at character 15: latitude 91.0° is outside −90° to 90°",
        "Sensor within -1 m of 1, 2 | at character 15: no module is within -1.0 m; ask for 0 m or"
            + " more",
        "Sensor within 50 m of 1 | at the end: a number is expected here, not the end",
      })
  void saysWhereAndWhatIsWrong(String query, String sentence) {
    assertThatThrownBy(() -> parser.parse(query))
        .isInstanceOf(QuerySyntaxException.class)
        .hasMessage(sentence);
  }

  @Test
  void whateverIsWrittenIsAQueryOrIsRefused() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    RandomQueries queries = new RandomQueries(seed);
    int refused = 0;
    for (int i = 0; i < QUERIES; i++) {
      StringBuilder text = new StringBuilder(queries.next().toString());
      for (int faults = 1 + random.nextInt(3); faults > 0; faults--) {
        int at = random.nextInt(Math.max(1, text.length()));
        switch (random.nextInt(3)) {
          case 0 -> text.delete(at, at + 1);
          case 1 -> text.insert(Math.min(at, text.length()), (char) (' ' + random.nextInt(96)));
          default -> text.setLength(Math.min(at, text.length()));
        }
      }
      try {
        ModuleQuery<? extends Module> query = parser.parse(text.toString());
        assertThat(query.kind()).as("seed %d: %s", seed, text).isNotNull();
      } catch (QuerySyntaxException e) {
        refused++;
        assertThat(e.position())
            .as("seed %d: %s: %s", seed, text, e.getMessage())
            .isBetween(1, text.length() + 1);
      }
    }
    assertThat(refused).isPositive();
  }
}
