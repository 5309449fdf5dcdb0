package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dfra.core.config.RobotXml.RobotXmlSchema;
import org.junit.jupiter.api.Test;

/**
 * The reference for users says what the schema and the reader of properties say, no less or more.
 */
class RobotReferenceTest {

  private static final Path ROOT =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"));
  private static final Pattern HEADING = Pattern.compile("(?m)^##+ (.*)$");
  private static final Pattern ROW = Pattern.compile("(?m)^\\| `([^`]+)`[^|]* \\|");

  private static String reference() throws IOException {
    return Files.readString(ROOT.resolve("docs/reference/robot-xml.md"));
  }

  /** The first column of the tables below each heading. */
  private static Map<String, List<String>> tables() throws IOException {
    String text = reference();
    List<MatchResult> headings = HEADING.matcher(text).results().toList();
    Map<String, List<String>> tables = new TreeMap<>();
    for (int i = 0; i < headings.size(); i++) {
      int end = i + 1 < headings.size() ? headings.get(i + 1).start() : text.length();
      String section = text.substring(headings.get(i).end(), end);
      tables.put(
          headings.get(i).group(1),
          ROW.matcher(section).results().map(row -> row.group(1)).toList());
    }
    return tables;
  }

  @Test
  void describesEveryElementAndAttributeOfTheSchemaAndNoOther() throws IOException {
    Map<String, List<String>> described = new TreeMap<>(tables());
    described.keySet().removeIf(heading -> !heading.startsWith("`<"));
    Map<String, List<String>> declared = new TreeMap<>();
    RobotXmlSchema.attributes()
        .forEach((element, attributes) -> declared.put("`<" + element + ">`", attributes));

    assertThat(declared).as("robot.xsd was read").hasSizeGreaterThan(5);
    assertThat(described.keySet()).isEqualTo(declared.keySet());
    declared.forEach(
        (element, attributes) ->
            assertThat(described.get(element))
                .as(element)
                .containsExactlyInAnyOrderElementsOf(attributes));
  }

  @Test
  void describesEveryKeyOfThePropertiesAndNoOther() throws IOException {
    assertThat(tables().get("Module properties"))
        .containsExactlyInAnyOrderElementsOf(ModuleProperties.KEYS);
  }

  @Test
  void namesTheNamespaceAndTheDefaults() throws IOException {
    assertThat(reference())
        .contains("`" + RobotXmlSchema.NAMESPACE.getURI() + "`")
        .contains("| `port` | default `" + RegistrarDescription.DEFAULT_PORT + "` |")
        .contains(
            "| `class-server-port` | default `"
                + RegistrarDescription.DEFAULT_CLASS_SERVER_PORT
                + "` |");
  }

  @Test
  void everyRobotWeShipCanBeReadWithoutAnyVariableSet() throws IOException {
    assertThat(files("config/robots", ".xml"))
        .isNotEmpty()
        .allSatisfy(
            file -> {
              RobotDescription robot = RobotXml.read(file, name -> null);
              assertThat(file).hasFileName(robot.name() + ".xml");
              assertThat(robot.registrar()).as(file + ": its own registrar").isPresent();
            });
  }

  @Test
  void everyModuleWeShipCanBeRead() throws IOException {
    assertThat(files("config/modules", ".properties"))
        .isNotEmpty()
        .allSatisfy(
            file ->
                assertThat(ModuleProperties.read(file, name -> null).values())
                    .containsKeys(
                        ModuleProperties.SERVER,
                        ModuleProperties.PROXY,
                        ModuleProperties.IMPLEMENTATION));
  }

  private static List<Path> files(String folder, String suffix) throws IOException {
    try (Stream<Path> files = Files.list(ROOT.resolve(folder))) {
      return files.filter(file -> file.toString().endsWith(suffix)).sorted().toList();
    }
  }
}
