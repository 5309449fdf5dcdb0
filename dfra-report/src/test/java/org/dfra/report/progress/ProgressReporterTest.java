package org.dfra.report.progress;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import org.dfra.report.terminal.Screen;
import org.dfra.report.terminal.Terminal;
import org.junit.jupiter.api.Test;

/** Sentences scroll above the block that is redrawn, and are the same where none is drawn. */
class ProgressReporterTest {

  private final StringWriter out = new StringWriter();
  private final ProgressReporter progress =
      new ProgressReporter(new PrintWriter(out), () -> 0, true, () -> new Terminal.Size(30, 24));

  private List<String> shown() {
    Screen screen = new Screen();
    screen.print(out.toString());
    return screen.lines();
  }

  @Test
  void everythingIsWrittenAboveTheBlock() {
    progress.heading("A chapter");
    progress.redraw(List.of("first", "second"));
    progress.say("A sentence.");
    progress.redraw(List.of("third", "fourth"));
    progress.section("testing", "Another chapter");
    progress.show(List.of("a table"));
    progress.figure("seen", 1, 2, "m");
    progress.table();
    List<String> shown = shown();
    assertThat(shown)
        .startsWith(
            "",
            "A chapter",
            "   0.000 s  A sentence.",
            "",
            "Another chapter",
            "    a table",
            "",
            "Measured")
        .endsWith(" third", " fourth")
        .doesNotContain(" first", " second");
    assertThat(shown.get(8)).as("a figure").contains("seen");
    assertThat(shown).hasSize(11);
  }

  /** Such as the message of a call that failed on a busy machine. */
  @Test
  void noLineIsWiderThanTheOthersWhateverASentenceContains() {
    StringWriter piped = new StringWriter();
    ProgressReporter plain = new ProgressReporter(new PrintWriter(piped), () -> 0);
    String endpoint =
        "BasicObjectEndpoint[6e1b7b1c-8a35-4b0e-9d9b-3c1f0f3a7e11,TcpEndpoint[127.0.0.1:40213],"
            + "org.dfra.river.call.DeadlineInvocationHandler$ThisIsALongNameOfANestedClass]";
    String why = "Remote exception to " + endpoint + "; nested exception is: \n\tTimeoutException";
    plain.say("ugv3 appears, but cannot be listened to: %s", why);
    plain.section("testing", "FAILED while " + why);
    plain.remark(why);
    assertThat(piped.toString().lines())
        .filteredOn(line -> line.length() > 96)
        .as("lines that are too wide")
        .isEmpty();
    assertThat(piped.toString().replaceAll("\\s+", ""))
        .contains(endpoint + ";nestedexceptionis:TimeoutException");
    plain.say("The logs are in %s.", "/" + "a/".repeat(60));
    assertThat(piped.toString()).as("a path can be copied").contains("/" + "a/".repeat(60));
  }

  /** A module's name comes from its robot, a failure's message from anywhere. */
  @Test
  void textOfOthersControlsNoTerminalAndBeginsNoLine() {
    String hostile = "gps\n2 stopped\u001b[2J\u009b2J\u202e";
    String shown = "2 stopped\\u001b[2J\\u009b2J\\u202e";
    StringWriter piped = new StringWriter();
    ProgressReporter plain = new ProgressReporter(new PrintWriter(piped), () -> 0);
    plain.say("%s has come.", hostile);
    plain.heading(hostile);
    plain.remark(hostile);
    plain.show(List.of(hostile));
    assertThat(piped.toString())
        .contains(shown + " has come.", "gps " + shown, "    gps\\n" + shown)
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}&&[^\n]]")
        .doesNotContainPattern("(?m)^2 stopped");
    progress.redraw(List.of(hostile));
    assertThat(out.toString()).contains(" gps\\n2 stopped\\u001b").doesNotContain("[2J\u009b");
  }

  @Test
  void aBlockThatIsSettledStaysWhereItIs() {
    progress.redraw(List.of("first"));
    progress.redraw(List.of("second"));
    progress.freezeLive();
    progress.heading("A chapter");
    progress.say("A sentence.");
    assertThat(shown()).containsExactly(" second", "", "A chapter", "   0.000 s  A sentence.");
  }

  @Test
  void aBlockIsCutWhereTheTerminalEnds() {
    progress.redraw(List.of("a line that is wider than thirty characters"));
    assertThat(shown()).containsExactly(" a line that is wider than th…");
  }

  @Test
  void whereNothingIsDrawnNothingIsSaidToTheTerminal() {
    progress.heading("A chapter");
    progress.say("A sentence.");
    progress.freezeLive();
    progress.show(List.of("a table"));
    assertThat(out.toString()).doesNotContain("\u001b");
    assertThat(shown())
        .containsExactly("", "A chapter", "   0.000 s  A sentence.", "    a table", "");
  }

  @Test
  void aTerminalWithoutColoursHasAWidthToo() {
    ProgressReporter plain =
        new ProgressReporter(new PrintWriter(out), () -> 0, false, () -> new Terminal.Size(60, 24));
    plain.say("%s", "word ".repeat(40).strip());
    assertThat(out.toString().lines()).allMatch(line -> line.length() <= 60).hasSizeGreaterThan(3);
    assertThat(plain.columns()).isEqualTo(60);
  }

  @Test
  void aSentenceIsBrokenWhereTheTerminalEnds() {
    String words = "word ".repeat(30).strip();
    for (int columns : new int[] {50, 80, 200}) {
      StringWriter output = new StringWriter();
      new ProgressReporter(
              new PrintWriter(output), () -> 0, true, () -> new Terminal.Size(columns, 24))
          .say("%s", words);
      int widest = output.toString().lines().mapToInt(String::length).max().orElseThrow();
      assertThat(widest)
          .as("on %d columns", columns)
          .isBetween(columns > 96 ? 92 : columns - 5, Math.min(96, columns));
    }
  }

  @Test
  void aSentenceIsAsWideAsEverWhereThereIsNoTerminal() {
    StringWriter output = new StringWriter();
    new ProgressReporter(new PrintWriter(output), () -> 0).say("%s", "word ".repeat(30).strip());
    assertThat(output.toString().lines().mapToInt(String::length).max().orElseThrow())
        .isBetween(92, 96);
  }

  /** The closing table, and the sentences below it. */
  @Test
  void figuresHaveColoursOnlyWhereTheyAreWanted() {
    for (boolean isColoured : new boolean[] {true, false}) {
      StringWriter output = new StringWriter();
      ProgressReporter closing =
          new ProgressReporter(
              new PrintWriter(output), () -> 0, false, () -> Terminal.Size.UNLIMITED, isColoured);
      closing.figure("receiver back", 7.3, 5, "s");
      closing.figure("collisions", 0, 0, "");
      closing.table();
      closing.remark("FAILED: this must be true.");
      if (isColoured) {
        assertThat(output.toString())
            .contains("\u001b[31mMISSED\u001b[0m", "\u001b[31mFAILED\u001b[0m: this");
      } else {
        assertThat(output.toString())
            .contains(" MISSED", "FAILED: this must be true.")
            .doesNotContainPattern("[\\p{Cntrl}&&[^\n]]");
      }
    }
  }
}
