package org.dfra.sim.world.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.world.file.WorldFolder.feature;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.RenamedNames;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** A world that was written before its names changed. */
@ResourceLock("RenamedNames") // the receiver of its warnings is the process's
class RenamedWorldNamesTest {

  @TempDir private Path temp;

  private final List<String> warnings = new CopyOnWriteArrayList<>();

  @BeforeEach
  void collectWarnings() {
    RenamedNames.onWarning(warnings::add);
  }

  @AfterEach
  void warnInTheLog() {
    RenamedNames.logWarnings();
  }

  private String warning(int line, String what, String old, String now) {
    return temp.resolve("world.xml")
        + ":"
        + line
        + ": "
        + what
        + " "
        + old
        + " is now called "
        + now
        + "; the old name works until the next release.";
  }

  @Test
  void anOldWorldIsReadAndEachOldNameIsReported() {
    WorldDescription world =
        new WorldFolder(temp)
            .document(
                """
                <world xmlns="urn:dfra:world:1" name="field">
                <datum latitude="48" longitude="11"/>
                <ground width="60" depth="40"/>
                <weather warming="5" wind="3" gusts="0.5"/>
                <mine east="1" north="2" contrast="-3"/>
                <defaults kind="gps"><parameter name="white" value="0.4"/></defaults>
                <robot name="r" type="ugv" east="5" north="5">
                <device kind="gps" name="gps" port="1">
                <parameter name="bias_time" value="20"/></device>
                </robot>
                </world>
                """)
            .read();
    assertThat(world.ground().sizeEast()).isEqualTo(60);
    assertThat(world.ground().sizeNorth()).isEqualTo(40);
    assertThat(world.weather().groundWarming()).isEqualTo(5);
    assertThat(world.weather().windSpeed()).isEqualTo(3);
    assertThat(world.weather().gustSigma()).isEqualTo(0.5);
    assertThat(world.mines().get(0).thermalContrast()).isEqualTo(-3);
    DeviceDescription gps = world.vehicles().get(0).devices().get(0);
    assertThat(gps.parameter("white_noise_sigma", VehicleType.UGV)).isEqualTo(0.4);
    assertThat(gps.parameter("bias_correlation_time", VehicleType.UGV)).isEqualTo(20);
    assertThat(warnings)
        .containsExactlyInAnyOrder(
            warning(3, "the attribute", "width", "size_east"),
            warning(3, "the attribute", "depth", "size_north"),
            warning(4, "the attribute", "warming", "ground_warming"),
            warning(4, "the attribute", "wind", "wind_speed"),
            warning(4, "the attribute", "gusts", "gust_sigma"),
            warning(5, "the attribute", "contrast", "thermal_contrast"),
            warning(6, "the parameter", "white", "white_noise_sigma"),
            warning(9, "the parameter", "bias_time", "bias_correlation_time"));
    assertThat(WorldXml.text(world)).contains("size_east=\"60.0\"").doesNotContain(" warming=");
  }

  @Test
  void theWidthOfARobotKeepsItsName() {
    new WorldFolder(temp)
        .xml("<robot name=\"r\" type=\"ugv\" east=\"5\" north=\"5\" width=\"0.7\"/>")
        .read();
    assertThat(warnings).isEmpty();
  }

  @Test
  void oldAndNewNameOfOneValueAreAFault() {
    assertThat(
            new WorldFolder(temp)
                .xml("<mine east=\"1\" north=\"2\" contrast=\"1\" thermal_contrast=\"1\"/>")
                .complaints())
        .containsExactly(
            "world.xml:2: <mine> has thermal_contrast and its old name contrast; delete contrast");
    assertThat(
            new WorldFolder(temp)
                .xml(
                    "<defaults kind=\"gyro\"><parameter name=\"bias_random_walk\" value=\"1\"/>",
                    "<parameter name=\"drift\" value=\"1\"/></defaults>")
                .complaints())
        .containsExactly(
            "world.xml:3: there is a second parameter bias_random_walk of the defaults of gyro, the"
                + " first is in line 2; delete one");
  }

  @Test
  void anOldPropertyOfAMineInGeoJsonIsRead() {
    String mine = "\"kind\": \"mine\", ";
    WorldDescription world =
        new WorldFolder(temp)
            .features(feature("Point", "[11.0001, 48.0001]", mine + "\"contrast\": -2"))
            .read();
    assertThat(world.mines().get(0).thermalContrast()).isEqualTo(-2);
    assertThat(warnings)
        .containsExactly(
            warning(2, "the property", "contrast", "thermal_contrast")
                .replace("world.xml", "things.geojson"));
    assertThat(
            new WorldFolder(temp)
                .features(
                    feature(
                        "Point",
                        "[11.0001, 48.0001]",
                        mine + "\"contrast\": -2, \"thermal_contrast\": 2"))
                .complaints())
        .containsExactly(
            "things.geojson:2: thermal_contrast and its old name contrast are both given; delete"
                + " contrast");
  }
}
