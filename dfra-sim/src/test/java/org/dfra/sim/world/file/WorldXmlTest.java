package org.dfra.sim.world.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.Map;
import java.util.Objects;
import org.dfra.core.config.SourceLocation;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorldXmlTest {

  private static final Path ROOT =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"));

  @TempDir Path temp;

  private static WorldDescription field() {
    return WorldXml.read(ROOT.resolve("config/worlds/field.xml"), name -> null);
  }

  @Test
  void readsTheFieldThatWeShip() {
    WorldDescription field = field();
    assertThat(field.seed()).isEqualTo(1);
    assertThat(field.datum()).isEqualTo(new GeoPosition(48, 11, 520));
    assertThat(field.obstacles()).hasSize(9);
    assertThat(field.mines()).hasSize(6);
    assertThat(field.vehicles()).extracting("name").containsExactly("atrv1", "atrv2", "uav1");
    assertThat(field.region().orElseThrow().area()).isCloseTo(56 * 36, within(0.1));
    World world = World.of(field, Instant.parse("2026-04-01T10:00:00Z"));
    double[] distances = new double[361];
    world.robot("atrv1").laser("laser").measure(world.start(), -1.57, 0.0087, 80, distances);
    assertThat(Arrays.stream(distances).min().orElseThrow()).isBetween(1.0, 80.0);
  }

  @Test
  void takesEveryValueFromWhereItIsWritten() {
    WorldDescription world =
        new WorldFolder(temp)
            .document(
                """
                <world xmlns="urn:dfra:world:1" name="w" seed="-7">
                <robot name="r" type="ugv" east="3" north="4" yaw="0.5" length="1" width="0.8" height="0.7">
                <device kind="pan-tilt" name="head" x="0.1" y="0.2" z="0.3" roll="0.4" pitch="0.5" yaw="0.6"/>
                <device kind="laser" name="eye" parent="head" protocol="lms200" link="sim:a" port="1" baud="2">
                <parameter name="dropout_probability" value=".25"/></device>
                <device kind="laser" name="other"/>
                </robot>
                <defaults kind="laser"><parameter name="dropout_probability" value="0.5"/><parameter name="white_noise_sigma" value="1e-2"/></defaults>
                <mine name="m" east="1" north="2" radius="0.3" height="0.2" thermal_contrast="-1.5" colour="#0102fF"/>
                <post name="p" east="-1" north="20" radius="0.5" height="3" reflectivity="0.9"/>
                <obstacle name="o" points="10,10 10,12 12,12" height="2" reflectivity="0.1"/>
                <region points="0,0 5,0 5,5"/>
                <weather temperature="280" ground_warming="5" sun_azimuth="1" sun_elevation="0.2" wind_speed="3" wind_towards="2" gust_sigma="1"/>
                <ground size_east="50" size_north="30" roughness="0.05"/>
                <datum latitude="-10" longitude="170" height="5"/>
                </world>
                """)
            .read();
    assertThat(world.seed()).isEqualTo(-7);
    assertThat(world.datum()).isEqualTo(new GeoPosition(-10, 170, 5));
    assertThat(world.ground().roughness()).isEqualTo(0.05);
    assertThat(world.weather().groundWarming()).isEqualTo(5);
    assertThat(world.weather().windTowards()).isEqualTo(2);
    MineDescription mine = world.mines().get(0);
    assertThat(mine.colour()).isEqualTo(0x0102FF);
    assertThat(mine.thermalContrast()).isEqualTo(-1.5);
    ObstacleDescription post = world.obstacles().get(0);
    assertThat(post.footprint()).isEqualTo(new Disc(-1, 20, 0.5));
    assertThat(post.reflectivity()).isEqualTo(0.9);
    assertThat(world.obstacles().get(1).footprint().contains(10.5, 11.5)).isTrue();
    assertThat(world.region().orElseThrow().corners()).contains(new Vertex(5, 5));
    DeviceDescription eye = world.vehicle("r").device("eye").orElseThrow();
    assertThat(eye.parent()).contains("head");
    assertThat(eye.emulator().protocol()).contains("lms200");
    assertThat(eye.emulator().link()).contains("sim:a");
    assertThat(eye.emulator().port()).contains("1");
    assertThat(eye.emulator().baud()).contains("2");
    assertThat(eye.parameters())
        .isEqualTo(Map.of("dropout_probability", 0.25, "white_noise_sigma", 0.01));
    DeviceDescription other = world.vehicle("r").device("other").orElseThrow();
    assertThat(other.parameter("dropout_probability", VehicleType.UGV)).isEqualTo(0.5);
    assertThat(other.parameter("range_at_10_percent", VehicleType.UGV))
        .isEqualTo(DeviceKind.LASER.parameter("range_at_10_percent").orElseThrow().ugvDefault());
    assertThat(world.vehicle("r").device("head").orElseThrow().mount().pitch()).isEqualTo(0.5);
  }

  @Test
  void whatIsWrittenReadsBackEqual() throws IOException {
    WorldFolder folder = new WorldFolder(temp);
    folder.write(
        "things.geojson",
        "{\"type\": \"FeatureCollection\", \"features\": ["
            + WorldFolder.feature("Point", "[11.0001, 48.0001]", "\"kind\": \"mine\"")
            + "]}");
    folder.xml(
        "<features href=\"things.geojson\"/>",
        "<post east=\"1.1\" north=\"2.2\"/><obstacle points=\"10,10 10,12 12,12.7\"/>",
        "<region points=\"0,0 5,0 5,5\"/>",
        "<robot name=\"r\" type=\"uav\" east=\"3\" north=\"4\" yaw=\"0.1\">",
        "<device kind=\"gps\" name=\"gps\" link=\"a$$b &amp;&quot;\"><parameter name=\"bias\""
            + " value=\"0.3\"/></device></robot>");
    WorldDescription world = folder.read();
    for (WorldDescription one : new WorldDescription[] {world, field()}) {
      Path copy = folder.path("copy.xml");
      WorldXml.write(one, copy);
      WorldDescription again = WorldXml.read(copy, name -> null);
      assertThat(again)
          .usingRecursiveComparison()
          .ignoringFieldsOfTypes(SourceLocation.class)
          .isEqualTo(one);
      assertThat(WorldXml.text(again)).isEqualTo(WorldXml.text(one));
    }
    assertThat(world.mines()).extracting("name").containsExactly("mine_1");
    assertThat(world.vehicle("r").device("gps").orElseThrow().emulator().link())
        .contains("a$b &\"");
  }

  /** At 48° a degree of latitude has 111 190 m, one of longitude 74 625 m (WGS84 tables). */
  @Test
  void geoJsonLiesWhereTheEarthSays() {
    WorldDescription world =
        new WorldFolder(temp)
            .features(
                WorldFolder.feature(
                    "Point", "[11.0004, 48.0003]", "\"kind\": \"post\", \"radius\": 0.2"),
                WorldFolder.feature(
                    "Polygon",
                    "[[[11.0001, 48.0001], [11.0002, 48.0001], [11.0002, 48.0002],"
                        + " [11.0001, 48.0001]]]",
                    "\"name\": \"hedge\", \"height\": 1.2"))
            .read();
    Disc post = (Disc) world.obstacles().get(0).footprint();
    assertThat(post.east()).isCloseTo(0.0004 * 74_625, within(0.001));
    assertThat(post.north()).isCloseTo(0.0003 * 111_190, within(0.001));
    assertThat(post.radius()).isEqualTo(0.2);
    ObstacleDescription hedge = world.obstacles().get(1);
    assertThat(hedge.name()).isEqualTo("hedge");
    assertThat(hedge.height()).isEqualTo(1.2);
    assertThat(((Polygon) hedge.footprint()).area()).isCloseTo(7.4625 * 11.1190 / 2, within(0.01));
  }
}
