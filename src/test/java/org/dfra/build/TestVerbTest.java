package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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
          *) for each in "$@" "MAVEN_OPTS=${MAVEN_OPTS:-}"; do echo "$each"; done >'%s' ;;
      esac
      [ ! -x during ] || . ./during
      """;

  @TempDir Path house;
  private ScriptFolder script;
  private PretendedReports pretended;
  private Path given;
  private String output = "";

  @BeforeEach
  void build() throws IOException {
    given = house.resolve("given");
    script = new ScriptFolder(house, BUILD_TOOL.formatted(given));
    pretended = new PretendedReports(house);
  }

  /** The exit code of {@code ./dfra test} with these words behind. */
  private int test(String tool, String... words) throws IOException, InterruptedException {
    int code = script.run(tool, "test", words);
    output = script.printed();
    return code;
  }

  private List<String> given(String tool, String... words) throws Exception {
    assertThat(test(tool, words)).as(output).isZero();
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
    assertThat(output)
        .isEqualTo(
            "dfra: --seed \""
                + seed
                + "\" is not a whole number of 64 bits; give the one that a failing test printed, or"
                + " new\n");
    assertThat(given).doesNotExist();
  }

  @Test
  void saysWhatASeedIsWhereNoneIsGiven() throws Exception {
    assertThat(test("maven", "--full", "--seed")).isEqualTo(64);
    assertThat(output)
        .isEqualTo(
            "dfra: --seed needs the number that a failing test printed, or new, as in: ./dfra test"
                + " --seed 42\n");
    assertThat(test("maven", "--help")).isZero();
    assertThat(output).contains("[--seed N|new]\n", "  --seed N  ");
  }

  @ParameterizedTest
  @CsvSource({"maven, -D", "gradle, -P"})
  void handsOnWhichOfTheThreeTiersIsToRun(String tool, String option) throws Exception {
    assertThat(given(tool)).contains(option + "dfra.full=false", option + "dfra.soak=false");
    assertThat(given(tool, "--full"))
        .contains(option + "dfra.full=true", option + "dfra.soak=false");
    assertThat(given(tool, "--soak"))
        .contains(option + "dfra.full=true", option + "dfra.soak=true");
  }

  /** A process of tests that may take hours is not ended as one that hangs. */
  @Test
  void givesASoakAllTheTimeItNeeds() throws Exception {
    assertThat(given("maven")).noneMatch(each -> each.startsWith("-Ddfra.test.timeout"));
    assertThat(given("maven", "--soak")).contains("-Ddfra.test.timeout=0");
  }

  /** Tests with java.rmi.activation in their signatures run beside others if Maven has it too. */
  @Test
  void runsTestsBesideEachOtherAndMeasuresAloneOnlyInAFullRun() throws Exception {
    String boot = "-Xbootclasspath/a:" + house.toRealPath() + "/dfra-activation/target/classes";
    assertThat(given("maven"))
        .contains(
            "-T",
            "-Ddfra.test.forks.across=4",
            "-Ddfra.test.alone=%regex[none]",
            "-Ddfra.test.paired=%regex[none]",
            "-Ddfra.test.order=alphabetical")
        .anyMatch(each -> each.startsWith("MAVEN_OPTS=") && each.endsWith(boot));
    assertThat(house.resolve("dfra-activation/target/classes")).isDirectory();
    assertThat(given("maven", "--full"))
        .contains(
            "-Ddfra.test.forks.across=3",
            "-Ddfra.test.alone=%regex[org/dfra/(app/Demo.*IT|attack/(FalseStop|StopBeside.*)IT"
                + "|drive/FirstOrderIT|examples/mission/process/.*IT|phoenix/KilledModuleIT)\\.class]",
            "-Ddfra.test.paired=%regex[org/dfra/(attack/([^f]|fuzz/[^F])|drive/|hosts/).*IT\\.class]",
            "-Ddfra.test.order=reversealphabetical")
        .as("Surefire refuses an exclamation mark in what is excluded")
        .noneMatch(each -> each.startsWith("-Ddfra.test.") && each.contains("!"));
  }

  /**
   * The number of processes for the modules' own tests, on the command line, must not reach it. And
   * what it misses is not repeated alone once more.
   */
  @Test
  void whatMeasuresIsAlone() throws Exception {
    String pom =
        Files.readString(Path.of(System.getProperty("dfra.root"), "src", "test", "pom.xml"));
    String pairs = pom.substring(pom.indexOf("<id>two-at-a-time</id>"));
    assertThat(pairs.substring(0, pairs.indexOf("</execution>")))
        .contains("<exclude>${dfra.test.alone}</exclude>");
    String alone = pom.substring(pom.indexOf("<id>one-at-a-time</id>"));
    assertThat(alone.substring(0, alone.indexOf("</execution>")))
        .contains(
            "<forkCount>1</forkCount>",
            "<dfra.test.repeats-overloaded>false</dfra.test.repeats-overloaded>");
  }

  /** As if the tool went on with the other modules after the first, which has a failed test. */
  @Test
  void countsTheTestsOfEveryModuleAndFailsIfOneOfThemDid() throws Exception {
    pretended.leave("dfra-a", "FirstTest", "1.5", true);
    pretended.leave("dfra-b", "SecondTest", "1,002.3", false);
    assertThat(test("maven")).as(output).isEqualTo(1);
    assertThat(output)
        .contains("dfra-a           Tests run: 2, Failures: 1", "dfra-b           Tests run: 2")
        .contains("failed: org.dfra.FirstTest.bad: was 2")
        .doesNotContain("build")
        .endsWith("\n3 passed, 1 failed, 0 skipped\n");
    assertThat(Files.readAllLines(given))
        .as("what keeps Maven from leaving out what comes after a failed test")
        .contains("--fail-at-end", "-Dmaven.test.failure.ignore=true");
  }

  @Test
  void passesIfAllTestsDo() throws Exception {
    pretended.leave("dfra-a", "FirstTest", "1.5", false);
    assertThat(test("maven")).as(output).isZero();
    assertThat(output).endsWith("\n2 passed, 0 failed, 0 skipped\n");
  }

  @Test
  void saysWhatTookLongestInTheLogAndOnTheScreen() throws Exception {
    pretended.leave("dfra-a", "FirstTest", "1.5", false);
    pretended.leave("dfra-b", "SecondTest", "1,002.3", false);
    for (int i = 0; i < 10; i++) {
      pretended.leave("dfra-c", "Third" + i + "Test", "3." + i, false);
    }
    assertThat(test("maven")).as(output).isZero();
    String slowest =
        "The slowest test classes, in seconds:\n"
            + "  1002.3  org.dfra.SecondTest\n"
            + "     3.9  org.dfra.Third9Test\n";
    assertThat(output)
        .contains(slowest)
        .contains(
            "The slowest tests, in seconds:\n"
                + "  1002.3  org.dfra.SecondTest.bad\n"
                + "     3.9  org.dfra.Third9Test.bad\n")
        .doesNotContain("3.0  org", "1.5  org");
    assertThat(Files.readString(house.resolve("target/test.log"))).contains(slowest);
  }

  /** Surefire writes no report of what it had to end, and Maven ignores failures. */
  @Test
  void countsAProcessOfTestsThatHungAndABuildThatFailed() throws Exception {
    pretended.leave("dfra-a", "FirstTest", "1.5", false);
    Path during = house.resolve("during");
    String ended = "echo '[ERROR] There was a timeout or other error in the fork'\n";
    Files.writeString(during, Files.readString(during) + ended);
    assertThat(test("maven")).as(output).isEqualTo(1);
    assertThat(output).contains("that hung").endsWith("\n2 passed, 1 failed, 0 skipped\n");
    Files.writeString(during, Files.readString(during) + "exit 1\n");
    assertThat(test("maven")).as(output).isEqualTo(1);
    assertThat(output).endsWith("\n2 passed, 2 failed, 0 skipped\n");
  }
}
