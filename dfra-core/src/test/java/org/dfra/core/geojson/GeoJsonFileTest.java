package org.dfra.core.geojson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GeoJsonFileTest {

  private static final String RING = "[[[11, 48, 510], [11.001, 48], [11, 48.001], [11, 48]]]";
  private static final String POLYGON = "{\"type\": \"Polygon\",\n \"coordinates\": " + RING + "}";

  @TempDir Path folder;
  private final ConfigurationFaults faults = new ConfigurationFaults();

  @Test
  void givesTheFeaturesOfACollectionWithTheirLines() throws IOException {
    GeoJsonFile file =
        read(
            "{\"features\": [\n{\"geometry\": "
                + POLYGON
                + ", \"properties\": {\"kind\": \"x\"}},\n",
            "{\"geometry\": {\"type\": \"Point\", \"coordinates\": [7, 8]}}],",
            "\"type\": \"FeatureCollection\"}");
    assertThat(file.isCollection()).isTrue();
    assertThat(file.features()).extracting(each -> each.place().line()).containsExactly(2, 5);
    assertThat(file.features())
        .extracting(GeoJsonFeature::type)
        .containsExactly("Polygon", "Point");
    assertThat(file.features().get(0).properties().path("kind").asText()).isEqualTo("x");
    assertThat(file.features().get(0).ring(faults).orElseThrow())
        .containsExactly(
            new GeoPosition(48, 11, 0),
            new GeoPosition(48, 11.001, 0),
            new GeoPosition(48.001, 11, 0),
            new GeoPosition(48, 11, 0));
    assertThat(faults.isEmpty()).isTrue();
  }

  @Test
  void takesAFeatureAndABareGeometryForOneFeature() throws IOException {
    GeoJsonFile feature = read("{\"type\": \"Feature\",", "\"geometry\": " + POLYGON + "}");
    assertThat(feature.type()).isEqualTo("Feature");
    assertThat(feature.features()).extracting(GeoJsonFeature::type).containsExactly("Polygon");
    GeoJsonFile bare = read("", POLYGON);
    assertThat(bare.type()).isEqualTo("Polygon");
    assertThat(bare.features()).extracting(each -> each.place().line()).containsExactly(2);
    assertThat(bare.features().get(0).ring(faults)).isPresent();
  }

  @Test
  void saysWhatIsNoJsonAndInWhichLine() throws IOException {
    assertThat(read("{", "\"type\": \"Feature\",", "oops}").isBroken()).isTrue();
    assertThatThrownBy(faults::throwIfAny)
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("some.geojson:3: this is not JSON (");
  }

  @Test
  void saysThatAMemberIsThereTwice() throws IOException {
    read("{\"type\": \"Feature\", \"geometry\": {}, \"geometry\": {}}");
    assertThatThrownBy(faults::throwIfAny)
        .hasMessageEndingWith("some.geojson: its member geometry is there twice; delete one");
  }

  @Test
  void givesNothingOfARootThatIsNone() throws IOException {
    assertThat(read("{\"type\": \"Topology\"}").features()).isEmpty();
    assertThat(read("{}").type()).isEqualTo("none");
    assertThat(read("{\"type\": \"FeatureCollection\"}").isCollection())
        .as("a collection without features")
        .isFalse();
    assertThat(faults.isEmpty()).isTrue();
  }

  private GeoJsonFile read(String... lines) throws IOException {
    Path file = folder.resolve("some.geojson");
    Files.writeString(file, String.join("\n", lines));
    return GeoJsonFile.read(file, faults);
  }
}
