package org.dfra.sim.world.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.sim.world.description.DeviceDescription.DeviceParameter;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The reference for users says what schema, kinds and defaults say, no less or more. */
class WorldReferenceTest {

  private static final Path ROOT =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"));
  private static final Pattern HEADING = Pattern.compile("(?m)^##+ (.*)$");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| `([^`]+)`[^|]* \\|");

  private static String reference() throws IOException {
    return Files.readString(ROOT.resolve("docs/reference/world-xml.md"));
  }

  /** The text below each heading. */
  private static Map<String, String> sections() throws IOException {
    String text = reference();
    List<MatchResult> headings = HEADING.matcher(text).results().toList();
    Map<String, String> sections = new TreeMap<>();
    for (int i = 0; i < headings.size(); i++) {
      int end = i + 1 < headings.size() ? headings.get(i + 1).start() : text.length();
      sections.put(headings.get(i).group(1), text.substring(headings.get(i).end(), end));
    }
    return sections;
  }

  @Test
  void describesEveryElementAndAttributeOfTheSchemaAndNoOther() throws IOException {
    Map<String, String> described = new TreeMap<>(sections());
    described.keySet().removeIf(heading -> !heading.startsWith("`<"));
    Map<String, List<String>> declared = new TreeMap<>();
    WorldXml.SCHEMA
        .attributes()
        .forEach((element, attributes) -> declared.put("`<" + element + ">`", attributes));
    assertThat(described.keySet()).isEqualTo(declared.keySet()).hasSizeGreaterThan(10);
    declared.forEach(
        (element, attributes) ->
            assertThat(
                    ROW.matcher(described.get(element)).results().map(row -> row.group(1)).toList())
                .as(element)
                .containsExactlyInAnyOrderElementsOf(attributes));
  }

  @Test
  void describesEveryKindWithItsParameters() throws IOException {
    Map<String, String> sections = sections();
    for (DeviceKind kind : DeviceKind.values()) {
      String section = sections.get("`" + kind.text() + "`");
      assertThat(section).as(kind.text()).isNotNull();
      assertThat(section.lines().filter(line -> line.startsWith("| `")))
          .as(kind.text())
          .containsExactlyElementsOf(
              kind.parameters().stream().map(WorldReferenceTest::row).toList());
    }
  }

  private static String row(DeviceParameter parameter) {
    String standard = number(parameter.ugvDefault());
    if (parameter.uavDefault() != parameter.ugvDefault()) {
      standard += ", " + number(parameter.uavDefault());
    }
    return "| `"
        + parameter.name()
        + "` | "
        + standard
        + " | "
        + number(parameter.min())
        + " to "
        + number(parameter.max())
        + " | "
        + parameter.unit()
        + " | "
        + parameter.meaning()
        + " |";
  }

  private static String number(double value) {
    return value == Math.rint(value)
        ? String.format(Locale.ROOT, "%.0f", value)
        : Double.toString(value);
  }

  @Test
  void namesTheDefaultsOfElements() throws IOException {
    WeatherDescription fair = WeatherDescription.FAIR;
    assertThat(reference())
        .contains("`" + WorldXml.SCHEMA.namespace().getURI() + "`")
        .contains("| `temperature` | default `" + fair.temperature() + "` |")
        .contains("| `ground_warming` | default `" + number(fair.groundWarming()) + "` |")
        .contains("| `sun_azimuth` | default `" + fair.sunAzimuth() + "` |")
        .contains("| `sun_elevation` | default `" + fair.sunElevation() + "` |")
        .contains("| `wind_speed` | default `" + number(fair.windSpeed()) + "` |")
        .contains("| `gust_sigma` | default `" + fair.gustSigma() + "` |")
        .contains("| `radius` | default `" + WorldObjectCollector.POST_RADIUS + "` |")
        .contains("| `height` | default `" + WorldObjectCollector.HEIGHT + "` |")
        .contains("| `reflectivity` | default `" + ObstacleDescription.REFLECTIVITY + "` |")
        .contains(
            String.format(
                "| `colour` | default `#%06X` |", ObstacleDescription.colour(new Disc(0, 0, 1))))
        .contains("| `radius` | default `" + MineDescription.RADIUS + "` |")
        .contains("| `thermal_contrast` | default `" + number(MineDescription.CONTRAST) + "` |")
        .contains(String.format("| `colour` | default `#%06X` |", MineDescription.COLOUR))
        .contains(
            "| `length` | default `"
                + VehicleType.UGV.length()
                + "`, `"
                + VehicleType.UAV.length()
                + "` of a uav |");
  }

  @Test
  void everyWorldWeShipCanBeReadWithoutAnyVariableSet(@TempDir Path temp) throws IOException {
    List<Path> worlds;
    try (Stream<Path> files = Files.list(ROOT.resolve("config/worlds"))) {
      worlds = files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    }
    assertThat(worlds).isNotEmpty();
    for (Path file : worlds) {
      assertThat(file).hasFileName(WorldXml.read(file, name -> null).name() + ".xml");
      WorldXml.write(WorldXml.read(file, name -> null), temp.resolve("copy.xml"));
      assertThat(WorldXml.read(temp.resolve("copy.xml"), name -> null).vehicles()).isNotEmpty();
    }
  }
}
