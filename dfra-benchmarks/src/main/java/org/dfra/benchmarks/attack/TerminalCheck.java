package org.dfra.benchmarks.attack;

import java.util.List;
import java.util.regex.Pattern;
import org.dfra.report.measurement.MeasuredValue;

/**
 * Checks the output of operator commands while {@linkplain HostileModule hostile text} was listed,
 * and counts the lines that would control a terminal or mislead its reader. Not thread-safe.
 */
public final class TerminalCheck {

  /**
   * Characters that control a terminal, reverse the text direction or end lines, except the line
   * separator that commands print.
   */
  public static final Pattern CONTROL = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}&&[^\n]]");

  private final StringBuilder all = new StringBuilder();
  private int lines;
  private int controlling;
  private int forged;

  /** Contains no output yet. */
  public TerminalCheck() {}

  /**
   * Adds a command's output.
   *
   * @param printed all of it, with lines that end in a line feed
   */
  public void add(String printed) {
    all.append(printed);
    for (String line : printed.split("\n", -1)) {
      lines++;
      controlling += CONTROL.matcher(line).find() ? 1 : 0;
      forged += line.startsWith(HostileModule.FORGED) ? 1 : 0;
    }
  }

  /** Whether a text was printed. */
  public boolean shows(String text) {
    return all.indexOf(text) >= 0;
  }

  /** All output, unchanged. */
  public String printed() {
    return all.toString();
  }

  /** The number of lines, and the number of those that an operator must not see. */
  public List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue("lines of the operator's output", lines, Double.POSITIVE_INFINITY, ""),
        new MeasuredValue("output lines with control characters", controlling, 0, ""),
        new MeasuredValue("output lines that begin with forged text", forged, 0, ""));
  }
}
