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
          *) for each in "$@" "MAVEN_OPTS=${MAVEN_OPTS:-}"; do echo "$each"; done >'%s' ;;
      esac
      [ ! -x during ] || . ./during
      """;

  /** What Surefire writes of a class, shortened. */
  private static final String REPORT =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <testsuite xmlns:xsi="x" version="3.0.2" name="org.dfra.%1$s" time="%2$s" tests="2" errors="0" skipped="0" failures="%3$d">
        <testcase name="good" classname="org.dfra.%1$s" time="0.1"/>
        <testcase name="bad" classname="org.dfra.%1$s" time="%2$s">
          %4$s
        </testcase>
      </testsuite>
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
            "-Ddfra.test.paired=%regex[none]")
        .anyMatch(each -> each.startsWith("MAVEN_OPTS=") && each.endsWith(boot));
    assertThat(house.resolve("dfra-activation/target/classes")).isDirectory();
    assertThat(given("maven", "--full"))
        .contains(
            "-Ddfra.test.forks.across=3",
            "-Ddfra.test.alone=%regex[org/dfra/(app/Demo(Raster|Recruit)IT|app/raster/process/.*IT)"
                + "\\.class]",
            "-Ddfra.test.paired=%regex[org/dfra/(app/Demo(Devices|Foundation|Persona)IT"
                + "|phoenix/KilledModuleIT|(attack|drive|hosts)/.*IT)\\.class]");
  }

  /** The number of processes for the modules' own tests, on the command line, must not reach it. */
  @Test
  void whatMeasuresIsAlone() throws Exception {
    String pom =
        Files.readString(Path.of(System.getProperty("dfra.root"), "src", "test", "pom.xml"));
    String alone = pom.substring(pom.indexOf("<id>one-at-a-time</id>"));
    assertThat(alone.substring(0, alone.indexOf("</execution>")))
        .contains("<forkCount>1</forkCount>");
  }

  /** Makes the build tool leave a module's report, as a run of it would. */
  private void leaveReport(String module, String test, String seconds, boolean failed)
      throws IOException {
    Path reports = house.resolve(module).resolve("target/surefire-reports");
    String failure = failed ? "<failure message=\"was 2\" type=\"x\"/>" : "";
    Path during = house.resolve("during");
    String script = Files.exists(during) ? Files.readString(during) : "";
    Files.writeString(
        during,
        script
            + "mkdir -p '%s'\ncat >'%s' <<'END'\n%sEND\n"
                .formatted(
                    reports,
                    reports.resolve("TEST-org.dfra." + test + ".xml"),
                    REPORT.formatted(test, seconds, failed ? 1 : 0, failure)));
    assertThat(during.toFile().setExecutable(true)).isTrue();
  }

  /** As if the tool went on with the other modules after the first, which has a failed test. */
  @Test
  void countsTheTestsOfEveryModuleAndFailsIfOneOfThemDid() throws Exception {
    leaveReport("dfra-a", "FirstTest", "1.5", true);
    leaveReport("dfra-b", "SecondTest", "1,002.3", false);
    assertThat(test("maven")).as(said).isEqualTo(1);
    assertThat(said)
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
    leaveReport("dfra-a", "FirstTest", "1.5", false);
    assertThat(test("maven")).as(said).isZero();
    assertThat(said).endsWith("\n2 passed, 0 failed, 0 skipped\n");
  }

  @Test
  void saysWhatTookLongestInTheLogAndOnTheScreen() throws Exception {
    leaveReport("dfra-a", "FirstTest", "1.5", false);
    leaveReport("dfra-b", "SecondTest", "1,002.3", false);
    for (int i = 0; i < 10; i++) {
      leaveReport("dfra-c", "Third" + i + "Test", "3." + i, false);
    }
    assertThat(test("maven")).as(said).isZero();
    String slowest =
        "The slowest test classes, in seconds:\n"
            + "  1002.3  org.dfra.SecondTest\n"
            + "     3.9  org.dfra.Third9Test\n";
    assertThat(said)
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
    leaveReport("dfra-a", "FirstTest", "1.5", false);
    Path during = house.resolve("during");
    String ended = "echo '[ERROR] There was a timeout or other error in the fork'\n";
    Files.writeString(during, Files.readString(during) + ended);
    assertThat(test("maven")).as(said).isEqualTo(1);
    assertThat(said).contains("that hung").endsWith("\n2 passed, 1 failed, 0 skipped\n");
    Files.writeString(during, Files.readString(during) + "exit 1\n");
    assertThat(test("maven")).as(said).isEqualTo(1);
    assertThat(said).endsWith("\n2 passed, 2 failed, 0 skipped\n");
  }

  /**
   * What the build tool leaves of a class that misses a bound during an overload, and, if it gets
   * one, a second report where it is run again.
   */
  private void leaveMiss(String reports, String test, String more, String second)
      throws IOException {
    Path during = house.resolve("during");
    String script = Files.exists(during) ? Files.readString(during) : "";
    Path report = house.resolve(reports).resolve("TEST-org.dfra." + test + ".xml");
    String missed =
        "<system-out><![CDATA[MISSED DURING AN OVERLOAD: it took 3 s]]></system-out>" + more;
    int failed = more.isEmpty() ? 0 : 1;
    Files.writeString(
        during,
        script
            + """
            mkdir -p '%1$s'
            case "$*" in
                *dfra.repeats=false*)
                    for each in "$@"; do echo "$each"; done >again
                    [ -z '%5$s' ] || cat >'%2$s' <<'END'
            %4$sEND
                    ;;
                *dfra.repeats=true*)
                    cat >'%2$s' <<'END'
            %3$sEND
                    ;;
            esac
            """
                .formatted(
                    report.getParent(),
                    report,
                    REPORT.formatted(test, "9", failed, missed),
                    REPORT.formatted(test, "2", second.equals(BAD) ? 1 : 0, second),
                    second));
    assertThat(during.toFile().setExecutable(true)).isTrue();
  }

  private static final String GOOD = " ";
  private static final String BAD = "<failure message=\"was 3\" type=\"x\"/>";

  /** The tests beside it may be what overloaded the computer. */
  @ParameterizedTest
  @CsvSource({
    "maven, target/surefire-reports, src/test/target/surefire-reports",
    "gradle, build/test-results/test, build/test-results/test"
  })
  void repeatsAloneWhatMissedABoundDuringAnOverload(String tool, String reports, String across)
      throws Exception {
    leaveMiss("dfra-a/" + reports, "FirstTest", "", GOOD);
    leaveMiss("dfra-b/" + reports, "SecondTest", "", BAD);
    leaveMiss("dfra-b/" + reports, "ThirdTest", "", GOOD);
    leaveMiss(across, "FourthIT", "", GOOD);
    assertThat(test(tool, "--seed", "7", "--full")).as(said).isEqualTo(1);
    assertThat(said)
        .contains("dfra: again, alone: ")
        .contains("org.dfra.FirstTest", "org.dfra.SecondTest", "org.dfra.FourthIT")
        .contains("failed: org.dfra.SecondTest.bad: was 3")
        .doesNotContain("during an overload")
        .endsWith("\n7 passed, 1 failed, 0 skipped\n");
    List<String> again = Files.readAllLines(house.resolve("again"));
    if (tool.equals("maven")) {
      assertThat(again)
          .contains("test", "-am", "-Ddfra.full=true", "-Ddfra.seed=7", "-Ddfra.test.forks=1")
          .contains(
              "-Dtest=org.dfra.FirstTest,org.dfra.SecondTest,org.dfra.ThirdTest,org.dfra.FourthIT")
          .containsSequence("-pl", "dfra-a,dfra-b,src/test")
          .doesNotContain("verify", "-T");
    } else {
      assertThat(again)
          .contains("-Pdfra.full=true", "-Pdfra.seed=7", "--max-workers=1")
          .containsSequence(":dfra-a:test", "--tests", "org.dfra.FirstTest")
          .containsSequence(
              ":dfra-b:test", "--tests", "org.dfra.SecondTest", "--tests", "org.dfra.ThirdTest")
          .containsSequence(":test", "--tests", "org.dfra.FourthIT");
    }
  }

  @Test
  void repeatsNothingThatFailedAndNothingThatMissedNoBound() throws Exception {
    leaveReport("dfra-a", "FirstTest", "1.5", false);
    leaveMiss("dfra-b/target/surefire-reports", "SecondTest", "\n    " + BAD, GOOD);
    assertThat(test("maven", "--full")).as(said).isEqualTo(1);
    assertThat(house.resolve("again")).doesNotExist();
    assertThat(said)
        .contains("missed during an overload: org.dfra.SecondTest.bad: it took 3 s")
        .contains("failed: org.dfra.SecondTest.bad: was 3")
        .doesNotContain("again, alone")
        .endsWith("\n3 passed, 1 failed, 0 skipped\n");
  }

  @Test
  void failsEverydayWhereABoundIsMissedAgainAlone() throws Exception {
    leaveMiss("dfra-a/target/surefire-reports", "FirstTest", "", BAD);
    assertThat(test("maven")).as(said).isEqualTo(1);
    assertThat(Files.readAllLines(house.resolve("again")))
        .contains("-Dtest=org.dfra.FirstTest", "-Ddfra.full=false", "-Ddfra.repeats=false");
    assertThat(said)
        .contains("dfra: again, alone: org.dfra.FirstTest\n")
        .contains("failed: org.dfra.FirstTest.bad: was 3")
        .endsWith("\n1 passed, 1 failed, 0 skipped\n");
  }

  @ParameterizedTest
  @CsvSource({"maven, target/surefire-reports", "gradle, build/test-results/test"})
  void repeatsThreeClassesEverydayAndNamesTheOthers(String tool, String reports) throws Exception {
    for (String each : List.of("A", "B", "C")) {
      leaveMiss("dfra-a/" + reports, each + "Test", "", GOOD);
    }
    leaveMiss("dfra-b/" + reports, "DTest", "", "");
    assertThat(test(tool)).as(said).isZero();
    assertThat(said)
        .contains("dfra: again, alone: org.dfra.ATest org.dfra.BTest org.dfra.CTest\n")
        .containsOnlyOnce("missed during an overload: ")
        .contains("missed during an overload: org.dfra.DTest.bad: it took 3 s")
        .endsWith("\n8 passed, 0 failed, 0 skipped\n");
    assertThat(Files.readString(house.resolve("again"))).doesNotContain("DTest");
  }

  /** Say because the second run ends at once: then nobody knows whether the bound is kept. */
  @ParameterizedTest
  @ValueSource(strings = {"--full", "--integration"})
  void failsWhereWhatMissedABoundCannotBeRepeated(String option) throws Exception {
    leaveMiss("dfra-a/target/surefire-reports", "FirstTest", "", "");
    assertThat(test("maven", option)).as(said).isEqualTo(1);
    assertThat(said)
        .contains("missed during an overload: org.dfra.FirstTest.bad: it took 3 s")
        .contains("could not be repeated")
        .endsWith("\n2 passed, 1 failed, 0 skipped\n");
  }

  /** Gradle may empty a folder of reports that it writes into. */
  @Test
  void countsTheOtherTestsOfAModuleWhoseReportsGradleRemoves() throws Exception {
    String reports = "dfra-a/build/test-results/test";
    Path during = house.resolve("during");
    String removed = "case \"$*\" in *dfra.repeats=false*) rm -rf " + reports + " ;; esac\n";
    Files.writeString(during, removed);
    leaveMiss(reports, "FirstTest", "", GOOD);
    Files.writeString(
        during,
        Files.readString(during)
            + "case \"$*\" in *dfra.repeats=true*) sed 's/MISSED//; s/FirstTest/OtherTest/'"
            + " <%1$s/TEST-org.dfra.FirstTest.xml >%1$s/TEST-org.dfra.OtherTest.xml ;; esac\n"
                .formatted(reports));
    assertThat(test("gradle", "--full")).as(said).isZero();
    assertThat(said).contains("again, alone").endsWith("\n4 passed, 0 failed, 0 skipped\n");
  }
}
