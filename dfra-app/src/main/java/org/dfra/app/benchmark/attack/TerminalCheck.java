package org.dfra.app.benchmark.attack;

import java.util.List;
import java.util.regex.Pattern;
import org.dfra.app.measurement.MeasuredValue;

/**
 * Looks at what an operator's command printed while {@linkplain HostileModule hostile text} was
 * listed, and counts the lines that would control a terminal or mislead its reader. For one thread.
 */
public final class TerminalCheck {

  /**
   * Characters that control a terminal, reverse the direction of writing or end lines; the end of a
   * line as commands write it is none of them.
   */
  public static final Pattern CONTROL = Pattern.compile("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}&&[^\n]]");

  private final StringBuilder all = new StringBuilder();
  private int lines;
  private int controlling;
  private int forged;

  /** Nothing was printed yet. */
  public TerminalCheck() {}

  /**
   * Adds what a command printed.
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

  /** All that was printed, as it was. */
  public String printed() {
    return all.toString();
  }

  /** How many lines were printed, and how many of them no operator should see. */
  public List<MeasuredValue> figures() {
    return List.of(
        new MeasuredValue("lines of the operator's output", lines, Double.POSITIVE_INFINITY, ""),
        new MeasuredValue("output lines with control characters", controlling, 0, ""),
        new MeasuredValue("output lines that begin with forged text", forged, 0, ""));
  }
}
