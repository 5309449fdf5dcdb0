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

/** What stops the wheels is not merely said: each line of the table names its tests. */
class EffectorsTest {

  private static final Pattern TEST = Pattern.compile("`(\\w+)\\.(\\w+)`");
  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));

  @Test
  void everyLineOfWhatStopsTheWheelsNamesATestThatThereIs() throws IOException {
    List<String> lines =
        Files.readAllLines(ROOT.resolve("docs/concepts/effectors.md")).stream()
            .filter(line -> line.startsWith("| the ") || line.startsWith("| a"))
            .toList();
    assertThat(lines).hasSizeGreaterThanOrEqualTo(10);
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
