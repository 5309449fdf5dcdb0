package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Mixin;

/** Answers have colours where the command line has, and nothing but text elsewhere. */
class AnswerTest {

  /** Answers as {@code status} and {@code module list} do. */
  @Command(name = "modules")
  static final class Modules implements Callable<Integer> {

    @Mixin private CommandOutput answer;

    @Override
    public Integer call() {
      Table table = new Table("MODULE", "STATE");
      table.row("r/gps", "ready");
      table.row("r/laser", "FAILED");
      table.row("r/drive", "MISSED");
      answer.table(List.of("gps", "laser", "drive"), table, "none");
      answer.lines("two", List.of("r/gps: READY", "r/laser: failed"));
      return ExitCode.SUCCESS;
    }
  }

  private static String answered(Ansi ansi, String... options) {
    StringWriter out = new StringWriter();
    CommandLine line = new CommandLine(new Modules());
    line.setColorScheme(CommandLine.Help.defaultColorScheme(ansi));
    line.setOut(new PrintWriter(out, true));
    assertThat(line.execute(options)).isZero();
    return out.toString();
  }

  @Test
  void inATerminalStatesHaveColours() {
    assertThat(answered(Ansi.ON))
        .contains("\u001b[32mready\u001b[0m", "\u001b[31mFAILED\u001b[0m")
        .contains("\u001b[31mMISSED\u001b[0m")
        .contains("\u001b[32mREADY\u001b[0m", "\u001b[31mfailed\u001b[0m");
  }

  @ParameterizedTest
  @EnumSource(
      value = Ansi.class,
      names = {"OFF", "AUTO"}) // a test has no terminal
  void elsewhereThereIsNoControlCharacter(Ansi ansi) {
    assertThat(answered(ansi))
        .contains("r/laser  FAILED", "r/gps: READY")
        .doesNotContainPattern("[\\p{Cntrl}&&[^\n]]");
    assertThat(answered(ansi, "--json")).doesNotContainPattern("[\\p{Cntrl}&&[^\n]]");
  }

  @Test
  void programsGetNoColoursInATerminalEither() {
    assertThat(answered(Ansi.ON, "--json")).doesNotContain("\u001b");
  }
}
