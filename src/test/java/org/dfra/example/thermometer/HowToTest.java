package org.dfra.example.thermometer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.Test;

/** The how-to shows what is compiled and run here, to the letter. */
class HowToTest {

  private static final Pattern CODE = Pattern.compile("(?s)```java\n(.*?)```");

  /** What the how-to writes for the version, which is in {@code pom.xml} only. */
  private static final String VERSION = "DFRA_VERSION";

  private static String read(String file) throws IOException {
    return Files.readString(Path.of(System.getProperty("dfra.root")).resolve(file));
  }

  private static String howTo() throws IOException {
    return read("docs/how-to/test-with-embedded-reggie.md");
  }

  @Test
  void showsTheTestThatRuns() throws IOException {
    Matcher shown = CODE.matcher(howTo());
    assertThat(shown.find()).as("a block of Java in the how-to").isTrue();
    assertThat(read("src/test/java/org/dfra/example/thermometer/ThermometerTest.java"))
        .endsWith(shown.group(1));
  }

  @Test
  void namesTheJarsAsTheyAreBuilt() throws IOException {
    String build = read("pom.xml");
    for (String module : List.of("dfra-testing", "dfra-activation")) {
      String named = "<artifactId>" + module + "</artifactId>";
      assertThat(build).contains("<module>" + module + "</module>");
      assertThat(read(module + "/pom.xml")).contains(named);
      assertThat(howTo())
          .contains(
              "<groupId>org.dfra</groupId>" + named + "<version>" + VERSION + "</version>",
              "org.dfra:" + module + ":" + VERSION);
    }
    assertThat(EmbeddedReggie.class.getProtectionDomain().getCodeSource().getLocation().getPath())
        .as("where org.dfra.testing is built")
        .contains("/dfra-testing/");
  }
}
