package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.build.PretendedReports.BAD;
import static org.dfra.build.PretendedReports.GOOD;

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

/** What {@code ./dfra test} runs again, alone, and what it reports then. */
@Timeout(120)
class RepeatedTestsTest {

  private static final String BUILD_TOOL =
      """
      #!/bin/sh
      case $1 in
          -v) echo "Apache Maven 3.9.9"; exit ;;
          --version) echo "Gradle 8.7"; exit ;;
      esac
      [ ! -x during ] || . ./during
      """;

  @TempDir Path house;
  private ScriptFolder script;
  private PretendedReports pretended;
  private String output = "";

  @BeforeEach
  void build() throws IOException {
    script = new ScriptFolder(house, BUILD_TOOL);
    pretended = new PretendedReports(house);
  }

  /** The exit code of {@code ./dfra test} with these words behind. */
  private int test(String tool, String... words) throws IOException, InterruptedException {
    int code = script.run(tool, "test", words);
    output = script.printed();
    return code;
  }

  /** The tests beside it may be what overloaded the computer. */
  @ParameterizedTest
  @CsvSource({
    "maven, target/surefire-reports, src/test/target/surefire-reports",
    "gradle, build/test-results/test, build/test-results/test"
  })
  void repeatsAloneWhatMissedABoundDuringAnOverload(String tool, String reports, String across)
      throws Exception {
    pretended.leaveMiss("dfra-a/" + reports, "FirstTest", "", GOOD);
    pretended.leaveMiss("dfra-b/" + reports, "SecondTest", "", BAD);
    pretended.leaveMiss("dfra-b/" + reports, "ThirdTest", "", GOOD);
    pretended.leaveMiss(across, "FourthIT", "", GOOD);
    assertThat(test(tool, "--seed", "7", "--full")).as(output).isEqualTo(1);
    assertThat(output)
        .contains("dfra: running again, alone: ")
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
    pretended.leave("dfra-a", "FirstTest", "1.5", false);
    pretended.leaveMiss("dfra-b/target/surefire-reports", "SecondTest", "\n    " + BAD, GOOD);
    assertThat(test("maven", "--full")).as(output).isEqualTo(1);
    assertThat(house.resolve("again")).doesNotExist();
    assertThat(output)
        .contains("missed during an overload: org.dfra.SecondTest.bad: it took 3 s")
        .contains("failed: org.dfra.SecondTest.bad: was 3")
        .doesNotContain("running again, alone")
        .endsWith("\n3 passed, 1 failed, 0 skipped\n");
  }

  @Test
  void failsEverydayWhereABoundIsMissedAgainAlone() throws Exception {
    pretended.leaveMiss("dfra-a/target/surefire-reports", "FirstTest", "", BAD);
    assertThat(test("maven")).as(output).isEqualTo(1);
    assertThat(Files.readAllLines(house.resolve("again")))
        .contains("-Dtest=org.dfra.FirstTest", "-Ddfra.full=false", "-Ddfra.test.repeats=false");
    assertThat(output)
        .contains("dfra: running again, alone: org.dfra.FirstTest\n")
        .contains("failed: org.dfra.FirstTest.bad: was 3")
        .endsWith("\n1 passed, 1 failed, 0 skipped\n");
  }

  @ParameterizedTest
  @CsvSource({"maven, target/surefire-reports", "gradle, build/test-results/test"})
  void repeatsThreeClassesEverydayAndNamesTheOthers(String tool, String reports) throws Exception {
    for (String each : List.of("A", "B", "C")) {
      pretended.leaveMiss("dfra-a/" + reports, each + "Test", "", GOOD);
    }
    pretended.leaveMiss("dfra-b/" + reports, "DTest", "", "");
    assertThat(test(tool)).as(output).isZero();
    assertThat(output)
        .contains("dfra: running again, alone: org.dfra.ATest org.dfra.BTest org.dfra.CTest\n")
        .containsOnlyOnce("missed during an overload: ")
        .contains("missed during an overload: org.dfra.DTest.bad: it took 3 s")
        .endsWith("\n8 passed, 0 failed, 0 skipped\n");
    assertThat(Files.readString(house.resolve("again"))).doesNotContain("DTest");
  }

  /** Say because the second run ends at once: then nobody knows whether the bound is kept. */
  @ParameterizedTest
  @ValueSource(strings = {"--full", "--integration"})
  void failsWhereWhatMissedABoundCannotBeRepeated(String option) throws Exception {
    pretended.leaveMiss("dfra-a/target/surefire-reports", "FirstTest", "", "");
    assertThat(test("maven", option)).as(output).isEqualTo(1);
    assertThat(output)
        .contains("missed during an overload: org.dfra.FirstTest.bad: it took 3 s")
        .contains("could not be repeated")
        .endsWith("\n2 passed, 1 failed, 0 skipped\n");
  }

  /** Gradle may empty a folder of reports that it writes into. */
  @Test
  void countsTheOtherTestsOfAModuleWhoseReportsGradleRemoves() throws Exception {
    String reports = "dfra-a/build/test-results/test";
    Path during = house.resolve("during");
    String removed = "case \"$*\" in *dfra.test.repeats=false*) rm -rf " + reports + " ;; esac\n";
    Files.writeString(during, removed);
    pretended.leaveMiss(reports, "FirstTest", "", GOOD);
    Files.writeString(
        during,
        Files.readString(during)
            + "case \"$*\" in *dfra.test.repeats=true*) sed 's/MISSED//; s/FirstTest/OtherTest/'"
            + " <%1$s/TEST-org.dfra.FirstTest.xml >%1$s/TEST-org.dfra.OtherTest.xml ;; esac\n"
                .formatted(reports));
    assertThat(test("gradle", "--full")).as(output).isZero();
    assertThat(output)
        .contains("running again, alone")
        .endsWith("\n4 passed, 0 failed, 0 skipped\n");
  }
}
