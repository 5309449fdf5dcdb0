package org.dfra.cli.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** What another computer has put into an exception. */
class PrintableTraceTest {

  private static final StackTraceElement FRAME = new StackTraceElement("Fake", "call", null, -1);

  private static Exception withFrames(int count, Throwable cause) {
    Exception thrown = new Exception("from afar", cause);
    StackTraceElement[] frames = new StackTraceElement[count];
    Arrays.fill(frames, FRAME);
    thrown.setStackTrace(frames);
    return thrown;
  }

  @Test
  void manyFramesAreCountedAndNotShown() {
    String[] lines = PrintableTrace.of(withFrames(100_000, null)).split(System.lineSeparator(), -1);
    assertThat(lines).hasSize(PrintableTrace.MOST_LINES + 2); // and the end of the last
    assertThat(lines[0]).isEqualTo("java.lang.Exception: from afar");
    assertThat(lines[lines.length - 2])
        .isEqualTo("... " + (100_001 - PrintableTrace.MOST_LINES) + " more lines omitted");
  }

  @Test
  void aDeepTraceOfThisMachineIsShownWhole() {
    assertThat(PrintableTrace.of(withFrames(1024, withFrames(0, null))))
        .contains("Caused by: java.lang.Exception: from afar")
        .doesNotContain("omitted");
  }
}
