package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.junit.jupiter.api.Test;
import picocli.CommandLine.Help.Ansi;

/** How findings look. */
class FindingPrinterTest {

  private static final List<Finding> FINDINGS =
      List.of(
          Finding.ok(Subject.JAVA, "Java 17"),
          Finding.warn(Subject.FILE_DESCRIPTORS, "few", "Have more."),
          Finding.fail(Subject.PORT, "taken", "Free it."));

  @Test
  void textOfOthersControlsNoTerminalAndBeginsNoLine() {
    Finding hostile =
        Finding.fail(Subject.REGISTRAR, "gps\nOK    \u001b[2J\u009b\u202e", "mend\n\u0007");
    assertThat(String.join("\n", new FindingPrinter(Ansi.OFF, 80).of(List.of(hostile))))
        .contains("gps\\nOK    \\u001b[2J\\u009b\\u202e", "→ mend\\n\\u0007")
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}&&[^\n]]")
        .doesNotContainPattern("(?m)^OK");
  }

  @Test
  void eachIsALineAndWhatToDoIsBelow() {
    assertThat(new FindingPrinter(Ansi.OFF, 80).of(FINDINGS))
        .containsExactly(
            "OK    java              Java 17",
            "WARN  file-descriptors  few",
            "                        → Have more.",
            "FAIL  port              taken",
            "                        → Free it.",
            "",
            "1 failure, 1 warning.");
    assertThat(new FindingPrinter(Ansi.OFF, 80).of(FINDINGS.subList(0, 1)))
        .endsWith("All is well.");
    assertThat(new FindingPrinter(Ansi.OFF, 80).of(FINDINGS.subList(0, 2)))
        .endsWith("Nothing fails, 1 warning.");
  }

  @Test
  void aLongFindingGoesOnBelowWhereItBeganAndWhatIsTypedStaysWhole() {
    Finding stop =
        Finding.warn(
            Subject.EMERGENCY_STOP,
            "atrv1/drive is stopped since noon, by root at 127.0.0.1, and executes no commands",
            "When it is safe for everybody, release it: ./dfra stop --release atrv1.");
    assertThat(new FindingPrinter(Ansi.OFF, 80).of(List.of(stop)).subList(0, 4))
        .containsExactly(
            "WARN  emergency-stop    atrv1/drive is stopped since noon, by root at 127.0.0.1,",
            "                        and executes no commands",
            "                        → When it is safe for everybody, release it:",
            "                          ./dfra stop --release atrv1.");
  }

  @Test
  void onATerminalVerdictsAreColoured() {
    assertThat(new FindingPrinter(Ansi.ON, 80).of(FINDINGS).get(0)).startsWith("\u001b[32mOK");
  }

  @Test
  void aCheckThatBreaksIsNoFinding() {
    Check broken =
        new Check() {
          @Override
          public Subject subject() {
            return Subject.PORT;
          }

          @Override
          public List<Finding> run() {
            throw new IllegalStateException("a fault of ours");
          }
        };
    org.assertj.core.api.Assertions.assertThatThrownBy(() -> CheckRunner.run(List.of(broken)))
        .hasMessage("a fault of ours");
  }
}
