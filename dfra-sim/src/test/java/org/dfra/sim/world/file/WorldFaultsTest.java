package org.dfra.sim.world.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.sim.world.file.WorldFolder.feature;

import java.nio.file.Path;
import org.dfra.core.config.ConfigurationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each complaint names file, line, what is wrong and what to do. */
class WorldFaultsTest {

  private static final String UGV = "<robot name=\"r\" type=\"ugv\" east=\"5\" north=\"5\">";

  @TempDir Path temp;

  private void refuses(String line, String complaint) {
    assertThat(new WorldFolder(temp).xml(line).complaints())
        .containsExactly("world.xml:2: " + complaint);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "<pst east=\"1\" north=\"1\"/>" + "|<pst> is not known here; did you mean \"post\"?",
        "<post est=\"1\" east=\"1\" north=\"1\"/>"
            + "|the attribute est is not known in <post>; did you mean \"east\"?",
        "<mine east=\"1\"/>|<mine> lacks its north; write north=\"…\" in it",
        "<mine east=\"NaN\" north=\"1\"/>|east is \"NaN\"; write a number, such as 1.5",
        "<mine east=\"1e999\" north=\"1\"/>|east is \"1e999\"; write a number, such as 1.5",
        "<mine east=\"1m\" north=\"1\"/>|east is \"1m\"; write a number, such as 1.5",
        "<mine east=\"1\" north=\"1\" radius=\"-1\"/>"
            + "|mine_1's radius is -1.0 m; write a number above 0, up to 10.0 m",
        "<mine east=\"1\" north=\"1\" thermal_contrast=\"500\"/>"
            + "|mine_1's thermal_contrast is 500.0 K; write a number from -100.0 to 100.0 K",
        "<mine east=\"1\" north=\"1\" colour=\"green\"/>"
            + "|colour is \"green\"; write red, green and blue as in #3F4526",
        "<mine name=\"Big One\" east=\"1\" north=\"1\"/>"
            + "|the mine name \"Big One\" is not lower_snake_case; write \"big_one\"",
        "<post east=\"1\" north=\"1\" radius=\"0\"/>|radius is 0.0 m; write a number above 0",
        "<post east=\"1\" north=\"1\" height=\"-2\"/>"
            + "|post_1's height is -2.0 m; write a number above 0, up to 1000.0 m",
        "<post east=\"1\" north=\"1\" reflectivity=\"2\"/>"
            + "|post_1's reflectivity is 2.0; write a number from 0.0 to 1.0",
        "<post east=\"90000\" north=\"1\"/>"
            + "|post_1 is 90 km from the datum, farther than 10 km; correct it or the datum, and see"
            + " that latitude and longitude are not swapped",
        "<obstacle points=\"0,0 1,1\"/>"
            + "|a polygon of 2 corners encloses nothing; give three or more",
        "<obstacle points=\"0,0 2,2 2,0 0,2\"/>"
            + "|the polygon crosses itself: the edge from 0.0,0.0 to 2.0,2.0 meets the one from"
            + " 2.0,0.0 to 0.0,2.0; give the corners in their order around it",
        "<obstacle points=\"0,0 1,1 2,2\"/>"
            + "|the polygon crosses itself: the edge from 0.0,0.0 to 1.0,1.0 meets the one from"
            + " 2.0,2.0 to 0.0,0.0; give the corners in their order around it",
        "<obstacle points=\"0,0 1,0 1,0 1,1\"/>"
            + "|the corner 1.0,0.0 is given twice in a row; delete one",
        "<obstacle points=\"0,0 1;0 1,1\"/>"
            + "|\"1;0\" in points is not a point; write east,north in metres, as in 12.5,3",
        "<obstacle points=\"0,0 1,NaN 1,1\"/>"
            + "|\"1,NaN\" in points is not a point; write east,north in metres, as in 12.5,3",
        "<datum latitude=\"1\" longitude=\"1\"/>"
            + "|there is a second <datum>, the first is in line 1; make them one",
        "<weather wind_speed=\"-1\"/>"
            + "|the weather's wind_speed is -1.0 m/s; write a number from 0.0 to 50.0 m/s",
        "<weather temperature=\"20\"/>"
            + "|the weather's temperature is 20.0 K; write a number from 200.0 to 350.0 K",
        "<defaults kind=\"lasr\"/>|kind is \"lasr\", which is unknown; did you mean \"laser\"?",
        "<defaults kind=\"gps\"><parameter name=\"white_noise_sigm\" value=\"1\"/></defaults>"
            + "|a gps has no parameter white_noise_sigm; did you mean \"white_noise_sigma\"?",
        "<features href=\"nowhere.geojson\"/>"
            + "|the file \"nowhere.geojson\" does not exist; name one, relative to world.xml",
        "<robot name=\"r\" type=\"usv\" east=\"1\" north=\"1\"/>"
            + "|type is \"usv\", which is unknown; did you mean \"ugv\"?",
        "<robot name=\"r\" type=\"ugv\" east=\"1\" north=\"1\" length=\"0\"/>"
            + "|r's length is 0.0 m; write a number above 0, up to 100.0 m",
        "<robot name=\"r\" type=\"ugv\" east=\"1\" north=\"1\" yaw=\"90\"/>"
            + "|r's yaw is 90.0 rad; write a number from -10.0 to 10.0 rad",
        "<post east=\"$X\" north=\"1\"/>"
            + "|the dollar in \"$X\" begins no variable; write ${NAME}, ${NAME:-default} or $$ for a"
            + " dollar itself",
      })
  void refusesWhatIsWrongInALine(String line, String complaint) {
    refuses(line, complaint);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "<device kind=\"radar\" name=\"a\"/>"
            + "|kind is \"radar\", which is unknown; write gps, laser, drive, gyro, pan-tilt,"
            + " camera, thermal, battery, flight",
        "<device kind=\"gps\" name=\"a\"/><device kind=\"laser\" name=\"a\"/>"
            + "|r has a second device a; rename or delete one",
        "<device kind=\"drive\" name=\"a\"/><device kind=\"drive\" name=\"b\"/>"
            + "|r has a second drive; delete one",
        "<device kind=\"flight\" name=\"a\"/>"
            + "|r is a ugv and cannot have a flight; delete it, or make the robot a uav",
        "<device kind=\"camera\" name=\"a\" parent=\"head\"/>"
            + "|a is mounted on head, which is not a pan-tilt of r; it has none, so delete the parent",
        "<device kind=\"pan-tilt\" name=\"head\"/><device kind=\"gps\" name=\"a\" parent=\"haed\"/>"
            + "|a is mounted on haed, which is not a pan-tilt of r; did you mean \"head\"?",
        "<device kind=\"pan-tilt\" name=\"head\"/>"
            + "<device kind=\"pan-tilt\" name=\"two\" parent=\"head\"/>"
            + "|two is mounted on head, but a pan-tilt is mounted on the robot itself; delete its parent",
        "<device kind=\"laser\" name=\"a\" pitch=\"1.5\"/>"
            + "|a is tilted by more than 60° from the level, which is not simulated; tilt it less",
        "<device kind=\"gps\" name=\"a\"><parameter name=\"bias_sigma\" value=\"-1\"/></device>"
            + "|bias_sigma is -1.0 m; write a number from 0.0 to 100.0 m",
        "<device kind=\"gps\" name=\"a\"><parameter name=\"bais_sigma\" value=\"1\"/></device>"
            + "|a gps has no parameter bais_sigma; did you mean \"bias_sigma\"?",
        "<device kind=\"gps\" name=\"a\"><parameter name=\"bias_sigma\" value=\"x\"/></device>"
            + "|value is \"x\"; write a number, such as 1.5",
        "<device kind=\"gps\" name=\"a\"><parameter name=\"bias_sigma\" value=\"1\"/>"
            + "<parameter name=\"bias_sigma\" value=\"2\"/></device>"
            + "|there is a second parameter bias_sigma of a, the first is in line 2; delete one",
        "<device kind=\"gps\" name=\"Front\"/>"
            + "|the device name \"Front\" is not lower_snake_case; write \"front\"",
        "<device kind=\"gps\" name=\"a\" x=\"Infinity\"/>"
            + "|x is \"Infinity\"; write a number, such as 1.5",
      })
  void refusesWhatIsWrongOnARobot(String devices, String complaint) {
    refuses(UGV + devices + "</robot>", complaint);
  }

  @Test
  void refusesADriveInTheAir() {
    refuses(
        "<robot name=\"u\" type=\"uav\" east=\"5\" north=\"5\"><device kind=\"drive\""
            + " name=\"a\"/></robot>",
        "u is a uav and cannot have a drive; delete it, or make the robot a ugv");
  }

  @Test
  void refusesARobotInsideAnObstacleAndTwoInOnePlace() {
    assertThat(
            new WorldFolder(temp)
                .xml(
                    "<obstacle name=\"house\" points=\"0,0 10,0 10,10 0,10\"/>",
                    UGV + "</robot>",
                    "<robot name=\"s\" type=\"ugv\" east=\"20\" north=\"20\"/>",
                    "<robot name=\"t\" type=\"ugv\" east=\"20.5\" north=\"20\"/>")
                .complaints())
        .containsExactly(
            "world.xml:3: r starts at the position of house; move one of them",
            "world.xml:5: t starts at the position of s; move one of them");
  }

  @Test
  void refusesTwoThingsWithOneName() {
    assertThat(
            new WorldFolder(temp)
                .xml(
                    "<post name=\"r\" east=\"1\" north=\"1\"/>",
                    UGV + "</robot>",
                    "<mine name=\"r\" east=\"2\" north=\"2\"/>")
                .complaints())
        .containsExactly(
            "world.xml:3: there is a second r among the obstacles, mines and robots; rename or"
                + " delete one",
            "world.xml:4: there is a second r among the obstacles, mines and robots; rename or"
                + " delete one");
  }

  @Test
  void reportsEverythingThatIsWrongAtOnce() {
    assertThat(
            new WorldFolder(temp)
                .document(
                    """
                    <world xmlns="urn:dfra:world:1" name="Field" seed="x">
                    <ground size_east="-1" size_north="nan"/>
                    <post east="1" north="1" height="0"/>
                    </world>""")
                .complaints())
        .containsExactly(
            "world.xml:1: seed is \"x\"; write a whole number, such as 1",
            "world.xml:1: the world has no <datum>; add one",
            "world.xml:1: the world name \"Field\" is not lower_snake_case; write \"field\"",
            "world.xml:2: size_north is \"nan\"; write a number, such as 1.5",
            "world.xml:2: the ground's size_east is -1.0 m; write a number above 0, up to 100000.0 m",
            "world.xml:3: post_1's height is 0.0 m; write a number above 0, up to 1000.0 m");
  }

  @Test
  void refusesWhatIsNoWorldAtAll() {
    WorldFolder folder = new WorldFolder(temp);
    assertThat(folder.document("<world name=\"w\"/>").complaints())
        .containsExactly(
            "world.xml:1: the root element is <world> in no namespace; write <world"
                + " xmlns=\"urn:dfra:world:1\" …>");
    assertThat(folder.document("<world").complaints())
        .singleElement()
        .asString()
        .startsWith("world.xml:1: the XML is not well-formed");
    assertThatThrownBy(() -> WorldXml.read(folder.path("none.xml")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageEndingWith("none.xml: there is no such file; name the XML file of a world");
    assertThat(
            folder
                .document(
                    "<world xmlns=\"urn:dfra:world:1\" name=\"w\"><ground size_east=\"1\""
                        + " size_north=\"1\"/><datum latitude=\"91\" longitude=\"0\"/></world>")
                .complaints())
        .containsExactly("world.xml:1: latitude 91.0° is outside −90° to 90°; write degrees");
  }

  private void refusesFeature(String feature, String complaint) {
    assertThat(new WorldFolder(temp).features(feature).complaints())
        .containsExactly("things.geojson:2: " + complaint);
  }

  @Test
  void refusesWrongFeatures() {
    refusesFeature(
        feature("LineString", "[[11, 48], [11, 48.1]]", ""),
        "the geometry of a feature is LineString, which a world does not use; write a Point for a"
            + " post or a mine, a Polygon for an obstacle or the region");
    refusesFeature(
        "{\"type\": \"Feature\"}",
        "the geometry of a feature is none, which a world does not use; write a Point for a post"
            + " or a mine, a Polygon for an obstacle or the region");
    refusesFeature(
        feature("Point", "[11, 48]", ""),
        "the kind of a point is missing; write post or mine in its properties");
    refusesFeature(
        feature("Point", "[11, 48]", "\"kind\": \"mien\""),
        "the kind of a point is mien; did you mean \"mine\"?");
    refusesFeature(
        feature("Polygon", "[[[11, 48], [11, 48.0001], [11.0001, 48]]]", "\"kind\": \"post\""),
        "the kind of a polygon is post; write obstacle or region in its properties");
    refusesFeature(
        feature("Point", "[11]", "\"kind\": \"mine\""),
        "[11] is not a position; write [longitude, latitude] in degrees, longitude first");
    refusesFeature(
        feature("Point", "[11, 480]", "\"kind\": \"mine\""),
        "[11,480] is not a position; write [longitude, latitude] in degrees, longitude first");
    refusesFeature(
        feature("Point", "[48, 11]", "\"kind\": \"mine\""),
        "mine_1 is 4747 km from the datum, farther than 10 km; correct it or the datum, and see"
            + " that latitude and longitude are not swapped");
    refusesFeature(
        feature("Point", "[11, 48]", "\"kind\": \"mine\", \"radius\": \"big\""),
        "radius is \"big\"; write a number, without quotes");
    refusesFeature(
        feature("Point", "[11, 48]", "\"kind\": \"post\", \"radius\": -1"),
        "radius is -1.0 m; write a number above 0");
    refusesFeature(
        feature("Point", "[11, 48]", "\"kind\": \"mine\", \"colour\": \"red\""),
        "colour is \"red\"; write red, green and blue as in #3F4526");
    refusesFeature(
        feature("Polygon", "[[[11, 48], [11, 48.001]], [[11, 48]]]", ""),
        "a polygon has 2 rings; write one, since a polygon here has no holes");
  }

  @Test
  void refusesSelfCrossingPolygonsOfGeoJson() {
    assertThat(
            new WorldFolder(temp)
                .features(
                    feature(
                        "Polygon",
                        "[[[11, 48], [11.0002, 48.0002], [11.0002, 48], [11, 48.0002], [11, 48]]]",
                        "\"name\": \"bow\""))
                .complaints())
        .singleElement()
        .asString()
        .startsWith("things.geojson:2: the polygon crosses itself: the edge from ");
  }

  @Test
  void refusesWhatIsNoGeoJson() {
    WorldFolder folder = new WorldFolder(temp);
    assertThat(folder.geoJson("{\n\"type\": \"FeatureCollection\",\n\"features\": [}").complaints())
        .singleElement()
        .asString()
        .startsWith("things.geojson:3: this is not JSON (");
    assertThat(folder.geoJson("[]").complaints())
        .containsExactly(
            "things.geojson:1: this is not a JSON object; write a FeatureCollection of GeoJSON");
    assertThat(folder.geoJson("").complaints())
        .containsExactly(
            "things.geojson:1: this is not a JSON object; write a FeatureCollection of GeoJSON");
    assertThat(folder.geoJson("{\"type\": \"Feature\", \"geometry\": {}}").complaints())
        .singleElement()
        .asString()
        .startsWith("things.geojson: its type is Feature; write a FeatureCollection");
    assertThat(folder.features("7").complaints())
        .singleElement()
        .asString()
        .startsWith("things.geojson:2: the geometry of a feature is none");
    assertThat(folder.features("{\"geometry\": NaN}").complaints())
        .singleElement()
        .asString()
        .startsWith("things.geojson:2: this is not JSON (");
  }

  @Test
  void refusesASecondRegion() {
    String region = "\"kind\": \"region\"";
    String corners = "[[[11, 48], [11.0001, 48], [11, 48.0001]]]";
    assertThat(
            new WorldFolder(temp)
                .features(feature("Polygon", corners, region), feature("Polygon", corners, region))
                .complaints())
        .containsExactly("things.geojson:3: there is a second region; delete one");
  }
}
