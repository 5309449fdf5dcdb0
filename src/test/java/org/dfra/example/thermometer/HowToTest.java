package org.dfra.example.thermometer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The how-to shows what is compiled and run here, to the letter. */
class HowToTest {

  private static final Pattern CODE = Pattern.compile("(?s)```java\n(.*?)```");

  @Test
  void showsTheTestThatRuns() throws IOException {
    Path root = Path.of(System.getProperty("dfra.root"));
    Matcher shown =
        CODE.matcher(Files.readString(root.resolve("docs/how-to/test-with-embedded-reggie.md")));
    assertThat(shown.find()).as("a block of Java in the how-to").isTrue();
    assertThat(
            Files.readString(
                root.resolve("src/test/java/org/dfra/example/thermometer/ThermometerTest.java")))
        .endsWith(shown.group(1));
  }
}
