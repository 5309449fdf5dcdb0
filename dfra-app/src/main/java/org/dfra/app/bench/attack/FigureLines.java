package org.dfra.app.bench.attack;

import java.util.List;
import org.dfra.app.figure.Figure;

/**
 * Figures that an attack has measured itself, as lines for the process that started it:
 *
 * <pre>
 *   figure MEASURED MOST UNIT WHAT      the unit of a plain number is -
 * </pre>
 */
public final class FigureLines {

  private static final String BEGINNING = "figure ";
  private static final String NO_UNIT = "-";
  private static final int COLUMNS = 5;

  private FigureLines() {}

  /** A figure as a line. */
  public static String write(Figure figure) {
    return BEGINNING
        + figure.measured()
        + " "
        + figure.most()
        + " "
        + (figure.unit().isEmpty() ? NO_UNIT : figure.unit())
        + " "
        + figure.what();
  }

  /**
   * The figures among a process's lines.
   *
   * @throws IllegalArgumentException if a line begins as one and is none
   */
  public static List<Figure> read(List<String> lines) {
    return lines.stream()
        .filter(line -> line.startsWith(BEGINNING))
        .map(FigureLines::read)
        .toList();
  }

  private static Figure read(String line) {
    String[] columns = line.split(" ", COLUMNS);
    if (columns.length < COLUMNS) {
      throw new IllegalArgumentException("\"" + line + "\" has fewer than " + COLUMNS + " columns");
    }
    return new Figure(
        columns[4],
        Double.parseDouble(columns[1]),
        Double.parseDouble(columns[2]),
        columns[3].equals(NO_UNIT) ? "" : columns[3]);
  }
}
