package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.core.config.ConfigurationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RegionFileTest {

  private static final String SQUARE =
      polygon("[[11, 48], [11.0002, 48], [11.0002, 48.0002], [11, 48.0002], [11, 48]]");
  private static final String TRIANGLE = polygon("[[11, 48], [11.0002, 48], [11, 48.0002]]");
  private static final String BOW =
      polygon("[[11, 48], [11.0002, 48.0002], [11.0002, 48], [11, 48.0002]]");
  private static final String REGION = "\"kind\": \"region\"";

  @TempDir Path folder;

  @Test
  void readsAPolygonAFeatureAndACollection() throws IOException {
    assertThat(read(SQUARE).corners()).hasSize(4);
    assertThat(read(feature(SQUARE, "")).corners()).hasSize(4);
    assertThat(read(collection(feature(TRIANGLE, ""), point())).corners()).hasSize(3);
    assertThat(
            read(collection(feature(TRIANGLE, "\"kind\": \"obstacle\""), feature(SQUARE, REGION)))
                .corners())
        .as("the one that says so")
        .hasSize(4);
  }

  @Test
  void readsTheRegionOfAWorld() {
    Path world = Path.of(System.getProperty("dfra.root"), "config/worlds/field.geojson");
    // 56 m by 36 m, as the world's XML has it
    assertThat(RegionFile.read(world).area()).isCloseTo(56 * 36, within(2.0));
  }

  @Test
  void namesFileAndLineOfWhatIsNoRegion() throws IOException {
    refuses(
        collection(point(), feature(BOW, REGION)), ":3: the outline of the region crosses itself");
    refuses(
        collection(feature(SQUARE, REGION), feature(TRIANGLE, REGION), feature(SQUARE, REGION)),
        ":3: there is a second region; delete one\n",
        ":4: there is a second region; delete one");
    refuses(
        collection(feature(SQUARE, ""), feature(TRIANGLE, "")),
        ": it has 2 polygons, and none is marked as the region; write \"kind\": \"region\" in"
            + " the properties of one");
    refuses(
        collection(point()),
        ": it contains no polygon (its type is FeatureCollection); write a Polygon, or a"
            + " Feature or FeatureCollection that contains one");
    refuses("{\"type\": \"Topology\"}", ": it contains no polygon (its type is Topology)");
    refuses(
        polygon("[[11, 48], [11.001, 48], [11, 48.001]], [[11, 48]]"),
        ":1: a polygon has 2 rings; write one, since a polygon here has no holes");
    refuses(
        polygon("[[11, 48], [11.001, 98], [11, 48.001]]"),
        ":1: [11.001,98] is not a position; write [longitude, latitude] in degrees, longitude"
            + " first");
    refuses("{\n\"type\": \"Polygon\",\n\"coordinates\": [[[11 48]]]}", ":3: this is not JSON (");
  }

  @Test
  void saysThatThereIsNoFile() {
    assertThatThrownBy(() -> RegionFile.read(folder.resolve("none.geojson")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageEndingWith("none.geojson: there is no such file; name a GeoJSON file");
  }

  private Region read(String text) throws IOException {
    Path file = folder.resolve("field.geojson");
    Files.writeString(file, text);
    return RegionFile.read(file);
  }

  private void refuses(String text, String... sentences) {
    String[] located = sentences.clone();
    for (int i = 0; i < located.length; i++) {
      located[i] = "field.geojson" + located[i];
    }
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContainingAll(located);
  }

  /** Each ring in brackets. */
  private static String polygon(String rings) {
    return "{\"type\": \"Polygon\", \"coordinates\": [" + rings + "]}";
  }

  private static String feature(String geometry, String properties) {
    return "{\"type\": \"Feature\", \"geometry\": "
        + geometry
        + ", \"properties\": {"
        + properties
        + "}}";
  }

  private static String point() {
    return feature("{\"type\": \"Point\", \"coordinates\": [11, 48]}", "\"kind\": \"post\"");
  }

  private static String collection(String... features) {
    return "{\"type\": \"FeatureCollection\", \"features\": [\n"
        + String.join(",\n", features)
        + "]}";
  }
}
