package org.dfra.report.terminal;

import java.util.ArrayList;
import java.util.List;
import org.dfra.text.PrintableText;

/**
 * Messages of this process: {@linkplain PrintableText printable}, and no wider than the terminal.
 * Continuation lines are indented, so that no text of another computer starts a line.
 */
public final class ConsoleMessages {

  private static final String PREFIX = "dfra: ";
  private static final int MARGIN = 2;

  private ConsoleMessages() {}

  /** A sentence of the output, without the end of its last line. */
  public static String wrapped(String sentence) {
    return folded(PrintableText.line(sentence), MARGIN);
  }

  /** A note beside the output, after {@value #PREFIX}. */
  public static String prefixed(String sentence) {
    return folded(PREFIX + PrintableText.line(sentence), PREFIX.length());
  }

  /**
   * The same for a text whose lines this program composed, such as the faults of a configuration:
   * lines after the first are indented.
   */
  public static String prefixedLines(String text) {
    List<String> lines = new ArrayList<>();
    String begin = PREFIX;
    for (String line : PrintableText.lines(text).split("\n", -1)) {
      lines.add(folded(begin + line, PREFIX.length()));
      begin = " ".repeat(PREFIX.length());
    }
    return String.join(System.lineSeparator(), lines);
  }

  private static String folded(String line, int indent) {
    return String.join(
        System.lineSeparator(), TextWrap.hangingIndent(line, Terminal.textColumns(), indent));
  }
}
