package org.dfra.benchmarks.attack;

import java.util.List;
import org.dfra.report.measurement.MeasuredValue;

/**
 * Measurements of an attack, as lines for the process that started it:
 *
 * <pre>
 *   figure MEASURED MOST UNIT WHAT      the unit of a plain number is -
 * </pre>
 */
public final class MeasuredValueLines {

  private static final String BEGINNING = "figure ";
  private static final String NO_UNIT = "-";
  private static final int COLUMNS = 5;

  private MeasuredValueLines() {}

  /** A measurement as a line. */
  public static String write(MeasuredValue figure) {
    return BEGINNING
        + figure.value()
        + " "
        + figure.target()
        + " "
        + (figure.unit().isEmpty() ? NO_UNIT : figure.unit())
        + " "
        + figure.name();
  }

  /**
   * The measurements among a process's lines.
   *
   * @throws IllegalArgumentException if a line starts like a measurement but is malformed
   */
  public static List<MeasuredValue> read(List<String> lines) {
    return lines.stream()
        .filter(line -> line.startsWith(BEGINNING))
        .map(MeasuredValueLines::read)
        .toList();
  }

  private static MeasuredValue read(String line) {
    String[] columns = line.split(" ", COLUMNS);
    if (columns.length < COLUMNS) {
      throw new IllegalArgumentException("\"" + line + "\" has fewer than " + COLUMNS + " columns");
    }
    return new MeasuredValue(
        columns[4],
        Double.parseDouble(columns[1]),
        Double.parseDouble(columns[2]),
        columns[3].equals(NO_UNIT) ? "" : columns[3]);
  }
}
