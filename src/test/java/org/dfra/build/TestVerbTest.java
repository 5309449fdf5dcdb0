package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What {@code ./dfra test} hands to the build tools. The script runs in a house of its own, with
 * build tools that only write down what they are given: this checkout's lock may be held by the
 * very run that this test is part of.
 */
@Timeout(120)
class TestVerbTest {

  private static final String BUILD_TOOL =
      """
      #!/bin/sh
      case $1 in
          -v) echo "Apache Maven 3.9.9" ;;
          --version) echo "Gradle 8.7" ;;
          *) for each in "$@"; do echo "$each"; done >'%s' ;;
      esac
      """;

  @TempDir Path house;
  private Path given;
  private String said = "";

  @BeforeEach
  void build() throws IOException {
    Path libexec = Files.createDirectories(house.resolve("src/dist/libexec"));
    Path root = Repository.root();
    Files.copy(root.resolve("dfra"), house.resolve("dfra"));
    Files.copy(root.resolve("src/dist/libexec/java.sh"), libexec.resolve("java.sh"));
    given = house.resolve("given");
    Path tools = Files.createDirectory(house.resolve("tools"));
    for (String name : List.of("mvn", "gradle")) {
      Path tool = Files.writeString(tools.resolve(name), BUILD_TOOL.formatted(given));
      assertThat(tool.toFile().setExecutable(true)).isTrue();
    }
  }

  /** The exit code of {@code ./dfra test} with these words behind. */
  private int test(String tool, String... words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("sh", house.resolve("dfra").toString(), "test"));
    command.addAll(List.of(words));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    Map<String, String> environment = builder.environment();
    environment.merge("PATH", house.resolve("tools") + ":", (old, first) -> first + old);
    environment.put("JAVA_HOME", System.getProperty("java.home"));
    environment.put("DFRA_BUILD", tool);
    Process script = builder.start();
    script.getOutputStream().close();
    said = new String(script.getInputStream().readAllBytes());
    return script.waitFor();
  }

  private List<String> given(String tool, String... words) throws Exception {
    assertThat(test(tool, words)).as(said).isZero();
    return Files.readAllLines(given);
  }

  @ParameterizedTest
  @CsvSource({"maven, -D", "gradle, -P"})
  void handsTheSeedOn(String tool, String option) throws Exception {
    String property = option + "dfra.seed=";
    assertThat(given(tool)).as("the build's own").noneMatch(each -> each.startsWith(property));
    assertThat(given(tool, "--seed", "42")).containsOnlyOnce(property + "42");
    assertThat(given(tool, "--seed", "0")).containsOnlyOnce(property + "0");
    assertThat(given(tool, "--seed", "-9223372036854775808", "--integration"))
        .containsOnlyOnce(property + Long.MIN_VALUE);
    assertThat(given(tool, "--seed", "new", "--full"))
        .as("nothing, so that every test draws its own")
        .containsOnlyOnce(property)
        .contains(option + "dfra.full=true");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "-", "-0", "4x", "1 2", "010", "+5", "-new", "1e3", "9223372036854775808"})
  void refusesASeedThatIsNoNumber(String seed) throws Exception {
    assertThat(test("maven", "--seed", seed)).isEqualTo(64);
    assertThat(said)
        .isEqualTo(
            "dfra: --seed \""
                + seed
                + "\" is no whole number of 64 bits; give the one that a failing test printed, or"
                + " new\n");
    assertThat(given).doesNotExist();
  }

  @Test
  void saysWhatASeedIsWhereNoneIsGiven() throws Exception {
    assertThat(test("maven", "--full", "--seed")).isEqualTo(64);
    assertThat(said)
        .isEqualTo(
            "dfra: --seed needs the number that a failing test printed, or new, as in: ./dfra test"
                + " --seed 42\n");
    assertThat(test("maven", "--help")).isZero();
    assertThat(said).contains("[--seed N|new]\n", "  --seed N  ");
  }
}
