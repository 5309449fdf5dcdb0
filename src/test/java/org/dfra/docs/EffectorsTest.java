package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What stops a robot is not merely said: each line of the tables names its tests. */
class EffectorsTest {

  private static final Pattern TEST = Pattern.compile("`(\\w+)\\.(\\w+)`");
  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));

  @Test
  void everyLineOfWhatStopsTheWheelsNamesATestThatThereIs() throws IOException {
    requireTests("docs/concepts/effectors.md", 10);
  }

  @Test
  void everyLineOfWhatStopsARobotNamesATestThatThereIs() throws IOException {
    requireTests("docs/concepts/what-stops-a-robot.md", 20);
  }

  @Test
  void everyTestThatIsNamedBesideTheTableIsThere() throws IOException {
    String text = Files.readString(ROOT.resolve("docs/concepts/what-stops-a-robot.md"));
    Matcher test = Pattern.compile("`(\\w+(?:Test|IT|Contract))\\.(\\w+)`").matcher(text);
    int named = 0;
    while (test.find()) {
      named++;
      assertThat(source(test.group(1))).contains(" void " + test.group(2) + "(");
    }
    assertThat(named).isGreaterThan(25);
  }

  private static void requireTests(String document, int atLeast) throws IOException {
    List<String> lines =
        Files.readAllLines(ROOT.resolve(document)).stream()
            .filter(line -> line.matches("\\| (the|an?|percepts|frames|no) .*"))
            .toList();
    assertThat(lines).hasSizeGreaterThanOrEqualTo(atLeast);
    for (String line : lines) {
      List<String> named = new ArrayList<>();
      Matcher test = TEST.matcher(line.substring(line.lastIndexOf('|', line.length() - 2)));
      while (test.find()) {
        named.add(test.group());
        assertThat(source(test.group(1)))
            .as("%s of the line %s", test.group(), line)
            .contains(" void " + test.group(2) + "(");
      }
      assertThat(named).as("tests of the line %s", line).isNotEmpty();
    }
  }

  private static String source(String test) throws IOException {
    try (Stream<Path> files =
        Files.find(
            ROOT,
            20,
            (path, attributes) ->
                attributes.isRegularFile()
                    && path.endsWith(test + ".java")
                    && path.toString().contains("test"))) {
      return Files.readString(
          files.findFirst().orElseThrow(() -> new AssertionError("there is no test " + test)));
    }
  }
}
