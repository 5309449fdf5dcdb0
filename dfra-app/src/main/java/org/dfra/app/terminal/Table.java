package org.dfra.app.terminal;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Rows under headings, each column as wide as its widest cell. What is longer than a terminal can
 * show beside other columns goes on in the next line, below where it began.
 */
public final class Table {

  private static final String GAP = "  ";
  private static final int WIDEST = 60;

  private final List<String> headings;
  private final List<List<String>> rows = new ArrayList<>();

  /**
   * @param headings of the columns
   */
  public Table(String... headings) {
    this.headings = List.of(headings);
  }

  /**
   * Adds a row.
   *
   * @param cells one for each column
   */
  public void row(String... cells) {
    if (cells.length != headings.size()) {
      throw new IllegalArgumentException(
          cells.length + " cells in a table of " + headings.size() + " columns");
    }
    rows.add(List.of(cells));
  }

  /** The lines, the headings first. */
  public List<String> lines() {
    List<List<String>> all = new ArrayList<>();
    all.add(headings);
    rows.forEach(row -> all.addAll(broken(row)));
    int[] widths =
        IntStream.range(0, headings.size())
            .map(column -> all.stream().mapToInt(row -> width(row.get(column))).max().orElse(0))
            .toArray();
    return all.stream().map(row -> line(row, widths)).toList();
  }

  /** The lines of a row, each with a cell for every column. */
  private static List<List<String>> broken(List<String> row) {
    List<List<String>> columns = row.stream().map(Table::pieces).toList();
    int height = columns.stream().mapToInt(List::size).max().orElse(0);
    return IntStream.range(0, height)
        .mapToObj(i -> columns.stream().map(each -> i < each.size() ? each.get(i) : "").toList())
        .toList();
  }

  /** A cell, broken at blanks. A word is never broken, so that it can be copied. */
  private static List<String> pieces(String cell) {
    if (width(cell) <= WIDEST) {
      return List.of(cell);
    }
    List<String> pieces = new ArrayList<>();
    StringBuilder piece = new StringBuilder();
    for (String word : cell.split(" ", -1)) {
      if (!piece.isEmpty() && width(piece + " " + word) > WIDEST) {
        pieces.add(piece.toString());
        piece.setLength(0);
      }
      piece.append(piece.isEmpty() ? "" : " ").append(word);
    }
    pieces.add(piece.toString());
    return pieces;
  }

  private static String line(List<String> cells, int[] widths) {
    StringBuilder line = new StringBuilder();
    for (int i = 0; i < cells.size(); i++) {
      line.append(i == 0 ? "" : GAP).append(cells.get(i));
      line.append(" ".repeat(widths[i] - width(cells.get(i))));
    }
    return line.toString().stripTrailing();
  }

  private static int width(String text) {
    return text.codePointCount(0, text.length());
  }
}
