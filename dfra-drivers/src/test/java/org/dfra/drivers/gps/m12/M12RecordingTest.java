package org.dfra.drivers.gps.m12;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.assertj.core.data.Offset;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.SharedData;
import org.dfra.drivers.gps.m12.M12Message.HeldPosition;
import org.dfra.drivers.gps.m12.M12Message.M12UtcOffset;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12Message.TimeScale;
import org.dfra.drivers.gps.m12.M12Message.VisibleSatellites;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.SatelliteChannel;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Recordings of two real receivers against what an independent decoder made of them.
 *
 * <p>The reference has one TPV and one SKY report for every position frame, in the same order.
 */
class M12RecordingTest {

  private static final String HA = "gps/oncore-m12.log";
  private static final String EA = "gps/oncore-binary.log";

  /**
   * The reference prints nine decimals and the receiver reports 2.8e-7°: half of the last decimal.
   */
  private static final Offset<Double> DEGREES = within(1e-9);

  /** The receiver reports centimetres, the reference prints tenths of millimetres. */
  private static final Offset<Double> METRES = within(1e-4);

  /** The receiver reports centimetres per second, the reference prints millimetres. */
  private static final Offset<Double> SPEED = within(1e-9);

  private static final Offset<Double> HEADING = within(1e-9); // tenths of a degree in both

  /** The reference rounds nanoseconds to milliseconds. */
  private static final Duration ROUNDING = Duration.ofMillis(1);

  @Test
  void findsTheFramesThatAreInTheTwelveChannelRecording() throws IOException {
    byte[] bytes = SharedData.bytes(HA);
    assertThat(framesIn(bytes))
        .isEqualTo(
            Map.of("Ha", 10L, "Bb", 9L, "As", 10L, "Gd", 10L, "Aw", 10L, "Ay", 10L, "Bo", 9L));
    assertThat(droppedIn(bytes)).isEqualTo(firstFrameIn(bytes)); // the comment at the top, no more
  }

  @Test
  void findsTheFramesThatAreInTheEightChannelRecording() throws IOException {
    byte[] bytes = SharedData.bytes(EA);
    // Counted by hand in a listing of the file; the reference has 12 TPV reports, one for each Ea.
    assertThat(framesIn(bytes))
        .isEqualTo(
            Map.of(
                "Bo", 12L, "Ea", 12L, "En", 12L, "As", 11L, "At", 11L, "Aw", 11L, "Ay", 11L, "Bb",
                2L));
    assertThat(droppedIn(bytes)).isEqualTo(firstFrameIn(bytes));
  }

  @Test
  void readsTheOtherMessagesOfTheTwelveChannelRecording() throws IOException {
    List<M12Message> messages = M12Parser.parse(SharedData.bytes(HA));
    assertThat(all(messages, PositionControl.class))
        .hasSize(10)
        .containsOnly(new PositionControl(PositionControl.Mode.HOLD));
    assertThat(all(messages, TimeScale.class)).hasSize(10);
    assertThat(all(messages, M12UtcOffset.class)).hasSize(9).containsOnly(new M12UtcOffset(18));
    M12PositionMessage first = all(messages, M12PositionMessage.class).get(0);
    assertThat(all(messages, HeldPosition.class))
        .hasSize(10)
        .allSatisfy(
            held -> {
              assertThat(held.position().latitude()).isEqualTo(first.position().latitude());
              assertThat(held.position().longitude()).isEqualTo(first.position().longitude());
              assertThat(held.position().height()).isEqualTo(first.position().height());
            });
    List<VisibleSatellites> skies = all(messages, VisibleSatellites.class);
    List<JsonNode> reference = reference(HA, "SKY");
    assertThat(skies).hasSize(9).allMatch(sky -> sky.count() == 7);
    // The reference has the directions from the Bb before: from its second report on.
    for (JsonNode satellite : reference.get(1).get("satellites")) {
      assertThat(skies.get(0).satellites())
          .anySatisfy(
              place -> {
                assertThat(place.satellite()).isEqualTo(satellite.get("PRN").asInt());
                assertThat(place.elevation()).isEqualTo(satellite.get("el").asInt());
                assertThat(place.azimuth()).isEqualTo(satellite.get("az").asInt());
              });
    }
  }

  @Test
  void readsTheOtherMessagesOfTheEightChannelRecording() throws IOException {
    List<M12Message> messages = M12Parser.parse(SharedData.bytes(EA));
    assertThat(messages).noneMatch(MalformedMessage.class::isInstance);
    // 13 are visible, and there is room for 12.
    assertThat(all(messages, VisibleSatellites.class))
        .hasSize(2)
        .allMatch(sky -> sky.count() == 13 && sky.satellites().size() == 12);
    assertThat(all(messages, TimeRaim.class))
        .hasSize(12)
        .allMatch(raim -> raim.pulse() && raim.solution() == TimeRaim.Solution.OK)
        .allMatch(raim -> raim.accuracy() == 54);
  }

  private static <T> List<T> all(List<M12Message> messages, Class<T> type) {
    return messages.stream().filter(type::isInstance).map(type::cast).toList();
  }

  @Test
  void agreesWithTheReferenceOnTheTwelveChannelRecording() throws IOException {
    List<M12PositionMessage> messages = positions(SharedData.bytes(HA));
    List<JsonNode> reports = reference(HA, "TPV");
    assertThat(reports).hasSameSizeAs(messages);
    // The first report is empty: the reference believes no date before it has seen the leap seconds
    // (Bo), which come at the end of the first second. Nothing to compare.
    assertThat(reports.get(0).has("lat")).isFalse();
    for (int i = 1; i < messages.size(); i++) {
      Position12Channels message = (Position12Channels) messages.get(i);
      compare(message, message.unfiltered(), message.speed3d(), reports.get(i));
      // The reference reports the unfiltered position and the speed in space, we the filtered and
      // the one over ground. In position hold, as here, they are the same.
      assertThat(message.position()).isEqualTo(message.unfiltered());
      assertThat(message.groundSpeed()).isEqualTo(message.speed3d());
      assertThat(message.mode()).isEqualTo(GpsFix.Mode.POSITION_HOLD);
      assertThat(reports.get(i).get("leapseconds").asInt()).isEqualTo(message.utcState().offset());
    }
    // Not compared: PDOP and HDOP. The receiver sends none in position hold; the reference's come
    // from its own geometry. altMSL comes from a geoid model, which the receiver does not have.
    assertThat(messages).allMatch(message -> message.dilution() == 0);
    compareSatellites(messages, reference(HA, "SKY"));
    for (int i = 0; i < messages.size(); i++) {
      assertThat(messages.get(i).visible())
          .isEqualTo(reference(HA, "SKY").get(i).get("nSat").asInt());
    }
  }

  @Test
  void agreesWithTheReferenceOnTheEightChannelRecording() throws IOException {
    List<M12PositionMessage> messages = positions(SharedData.bytes(EA));
    List<JsonNode> reports = reference(EA, "TPV");
    assertThat(reports).hasSameSizeAs(messages);
    List<JsonNode> skies = reference(EA, "SKY");
    for (int i = 0; i < messages.size(); i++) {
      Position8Channels message = (Position8Channels) messages.get(i);
      compare(message, message.position(), message.groundSpeed(), reports.get(i));
      assertThat(message.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      assertThat(message.isHorizontalDilution()).isFalse();
      assertThat(message.dilution()).isEqualTo(skies.get(i).get("pdop").asDouble());
      assertThat(message.antenna()).isEqualTo(ReceiverStatus.Antenna.OK);
      // Not compared with nSat: the reference counts the satellites that Bb lists, at most 12. The
      // receiver says that it sees 13.
      assertThat(message.visible()).isEqualTo(13);
    }
    compareSatellites(messages, skies);
  }

  @Test
  @Timeout(30)
  void theDriverServesARecordingAsItServesAReceiver() throws Exception {
    String link = "replay:" + SharedData.path(HA) + "?pace=50&loop=true";
    Parameters parameters = Parameters.of("atrv1/gps_front", Map.of("link", link));
    try (M12PlusImpl gps =
        new M12PlusImpl(
            new ModuleContext("atrv1", "gps_front", parameters, InstantSource.system()))) {
      gps.start();
      assertThat(gps.awaitReadiness(Duration.ofSeconds(20))).isEqualTo(Readiness.READY);
      GeoPosition position = gps.location().position();
      assertThat(position.latitude()).isCloseTo(52.910313611, DEGREES);
      assertThat(position.longitude()).isCloseTo(6.866706667, DEGREES);
      assertThat(position.height()).isCloseTo(55.91, METRES);
      assertThat(gps.fix().satellitesTracked()).isEqualTo(7);
      List<Instant> times =
          reference(HA, "TPV").stream()
              .filter(report -> report.has("time"))
              .map(report -> Instant.parse(report.get("time").asText()))
              .toList();
      assertThat(gps.fix().utc())
          .as("as it was recorded, however long ago that is; the first reports have no time")
          .isBetween(times.get(0).minusSeconds(2), times.get(times.size() - 1).plus(ROUNDING));
      assertThat(gps.counts().malformed()).isZero();
    }
  }

  private static void compare(
      M12PositionMessage message, M12Position position, double speed, JsonNode report) {
    String where = report.toString();
    assertThat(position.latitude()).as(where).isCloseTo(number(report, "lat"), DEGREES);
    assertThat(position.longitude()).as(where).isCloseTo(number(report, "lon"), DEGREES);
    assertThat(position.height()).as(where).isCloseTo(number(report, "altHAE"), METRES);
    assertThat(speed).as(where).isCloseTo(number(report, "speed"), SPEED);
    assertThat(message.heading()).as(where).isCloseTo(number(report, "track"), HEADING);
    Instant time = Instant.parse(report.get("time").asText());
    assertThat(Duration.between(time, message.utc()).abs()).as(where).isLessThan(ROUNDING);
    assertThat(message.knowsUtc()).isEqualTo(message instanceof Position12Channels);
  }

  /**
   * Satellites the receiver works on: number, signal, whether used. Those the reference lists as
   * unused it knows from another message (Bb), which is not decoded here.
   */
  private static void compareSatellites(List<M12PositionMessage> messages, List<JsonNode> skies) {
    assertThat(skies).hasSameSizeAs(messages);
    for (int i = 0; i < messages.size(); i++) {
      List<String> expected = new ArrayList<>();
      for (JsonNode satellite : skies.get(i).get("satellites")) {
        if (satellite.get("used").asBoolean()) {
          expected.add(satellite.get("PRN").asInt() + " at " + satellite.get("ss").asInt());
        }
      }
      List<String> reported =
          messages.get(i).channels().stream()
              .filter(SatelliteChannel::isAvailable)
              .map(channel -> channel.satellite() + " at " + channel.carrierToNoise())
              .toList();
      assertThat(reported).as("position frame %d", i).isEqualTo(expected);
      assertThat(messages.get(i).tracked()).isEqualTo(skies.get(i).get("uSat").asInt());
    }
  }

  private static double number(JsonNode report, String field) {
    return report.get(field).asDouble();
  }

  private static List<M12PositionMessage> positions(byte[] bytes) {
    return M12Parser.parse(bytes).stream()
        .filter(M12PositionMessage.class::isInstance)
        .map(M12PositionMessage.class::cast)
        .toList();
  }

  private static Map<String, Long> framesIn(byte[] bytes) {
    return M12Parser.parse(bytes).stream().collect(groupingBy(M12Message::id, counting()));
  }

  private static long droppedIn(byte[] bytes) {
    M12Parser parser = new M12Parser(message -> {});
    parser.feed(bytes, 0, bytes.length);
    parser.finish();
    return parser.counts().droppedBytes();
  }

  private static int firstFrameIn(byte[] bytes) {
    int at = 0;
    while (bytes[at] != '@' || bytes[at + 1] != '@') {
      at++;
    }
    return at;
  }

  private static List<JsonNode> reference(String recording, String kind) throws IOException {
    ObjectMapper mapper = new ObjectMapper();
    List<JsonNode> reports = new ArrayList<>();
    for (String line : Files.readAllLines(SharedData.path(recording + ".chk"))) {
      if (line.startsWith("{")) {
        JsonNode report = mapper.readTree(line);
        if (report.get("class").asText().equals(kind)) {
          reports.add(report);
        }
      }
    }
    return reports;
  }
}
