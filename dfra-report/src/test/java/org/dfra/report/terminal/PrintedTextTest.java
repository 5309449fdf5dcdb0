package org.dfra.report.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Mixin;

/** Text of other computers controls no terminal and begins no line, whatever prints it. */
class PrintedTextTest {

  /** Clears the screen, writes the clipboard, begins a line, turns the direction of writing. */
  private static final String HOSTILE = "x\n2 stopped\r\u001b[2J\u001b]52;c;eA==\u0007\u009b\u202e";

  private static final String SHOWN =
      "x\\n2 stopped\\r\\u001b[2J\\u001b]52;c;eA==\\u0007\\u009b\\u202e";

  private static final String OURS = "\u001b\\[(?:0|1|31|32)m";

  /** Gives hostile text by each way that an answer has. */
  @Command(name = "says")
  static final class Says implements Callable<Integer> {

    @Mixin private CommandOutput answer;

    @Override
    public Integer call() {
      Table table = new Table("MODULE", "STATE");
      table.row(HOSTILE, "ready");
      table.row("b", HOSTILE);
      answer.table(List.of(HOSTILE), table, "none");
      answer.table(List.of(), table, HOSTILE);
      answer.details(Map.of(HOSTILE, List.of(HOSTILE, "b")));
      answer.lines(HOSTILE, List.of(HOSTILE));
      answer.sentence(HOSTILE, HOSTILE);
      answer.line(HOSTILE, HOSTILE);
      answer.note(HOSTILE);
      return ExitCode.SUCCESS;
    }
  }

  private record Printed(String out, String err) {}

  private static Printed printed(Ansi ansi, String... options) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine line = new CommandLine(new Says());
    line.setColorScheme(CommandLine.Help.defaultColorScheme(ansi));
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    assertThat(line.execute(options)).isZero();
    return new Printed(out.toString(), err.toString());
  }

  private static void assertHarmless(String text) {
    assertThat(text)
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}&&[^\n]]")
        .doesNotContainPattern("(?m)^ *2 stopped");
  }

  @Test
  void anAnswerShowsItAndStaysInItsLine() {
    Printed printed = printed(Ansi.OFF);
    assertHarmless(printed.out());
    assertThat(printed.out().split("x\\\\n2 stopped", -1)).as("times shown").hasSizeGreaterThan(5);
    assertThat(printed.err()).isEqualTo("dfra: " + SHOWN + System.lineSeparator());
  }

  @Test
  void ourOwnColoursStay() {
    String out = printed(Ansi.ON).out();
    assertThat(out).contains("\u001b[32mready\u001b[0m", "\u001b[1mMODULE");
    assertHarmless(out.replaceAll(OURS, ""));
  }

  @Test
  void programsReadTheTextItself() throws Exception {
    String out = printed(Ansi.OFF, "--json").out();
    assertHarmless(out);
    assertThat(new ObjectMapper().readTree(Json.line(Map.of("name", HOSTILE))).get("name").asText())
        .isEqualTo(HOSTILE);
    assertThat(new ObjectMapper().readTree(Json.pretty(List.of(HOSTILE))).get(0).asText())
        .isEqualTo(HOSTILE);
  }

  @Test
  void aFailureStaysInItsLineAndFaultsAreIndented() {
    assertThat(ConsoleMessages.prefixed(HOSTILE)).isEqualTo("dfra: " + SHOWN);
    assertThat(ConsoleMessages.prefixedLines("one\ntwo\u001b"))
        .isEqualTo("dfra: one" + System.lineSeparator() + "      two\\u001b");
  }

  /** A first cell that is folded could begin a line with its second part. */
  @Test
  void partOfAFirstCellBeginsNoLine() {
    Table table = new Table("MODULE", "STATE");
    table.row("a".repeat(40) + " ".repeat(30) + "2 effectors: 2 stopped.", "ready");
    assertThat(table.lines(70)).noneMatch(line -> line.startsWith("2 effectors"));
  }
}
