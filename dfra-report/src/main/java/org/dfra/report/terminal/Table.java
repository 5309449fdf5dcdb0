package org.dfra.report.terminal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import org.dfra.text.PrintableText;

/**
 * Rows under headings, each column as wide as its widest cell. If that is wider than the terminal,
 * the widest columns are wrapped at words; if words are too long even for that, each row becomes a
 * paragraph, with a line for each cell. No word is ever broken.
 */
public final class Table {

  private static final String GAP = "  ";
  private static final int WIDEST = 60;

  /** Maximum length of a cell, in UTF-16 code units. */
  private static final int LONGEST_CELL = 2_000;

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
   * @param cells one for each column; they are made {@linkplain PrintableText printable}
   */
  public void row(String... cells) {
    if (cells.length != headings.size()) {
      throw new IllegalArgumentException(
          cells.length + " cells in a table of " + headings.size() + " columns");
    }
    rows.add(Arrays.stream(cells).map(cell -> PrintableText.line(cell, LONGEST_CELL)).toList());
  }

  /** The lines, the headings first, however wide. */
  public List<String> lines() {
    return lines(Integer.MAX_VALUE);
  }

  /**
   * The lines, the headings first.
   *
   * @param columns that the terminal has
   */
  public List<String> lines(int columns) {
    int[] widths = widths(TextWrap::width, WIDEST);
    int[] least = widths(TextWrap::longestWord, Integer.MAX_VALUE);
    while (total(widths) > columns) {
      int widest = foldable(widths, least);
      if (widest < 0) {
        return paragraphs(columns);
      }
      widths[widest]--;
    }
    List<String> lines = new ArrayList<>();
    lines.addAll(folded(headings, widths));
    rows.forEach(row -> lines.addAll(folded(row, widths)));
    return lines;
  }

  /** The width of the widest cell of each column; a word longer than the limit counts fully. */
  private int[] widths(ToIntFunction<String> measure, int limit) {
    return IntStream.range(0, headings.size())
        .map(
            column ->
                rows.stream()
                    .map(row -> row.get(column))
                    .mapToInt(cell -> limited(cell, measure, limit))
                    .reduce(measure.applyAsInt(headings.get(column)), Math::max))
        .toArray();
  }

  private static int limited(String cell, ToIntFunction<String> measure, int limit) {
    int wide = measure.applyAsInt(cell);
    return wide <= limit
        ? wide
        : TextWrap.wrap(cell, limit).stream().mapToInt(TextWrap::width).max().orElse(0);
  }

  private static int total(int[] widths) {
    return Arrays.stream(widths).sum() + GAP.length() * (widths.length - 1);
  }

  /** The widest column that can be narrower; -1 if there is none. */
  private static int foldable(int[] widths, int[] least) {
    int widest = -1;
    for (int i = 0; i < widths.length; i++) {
      if (widths[i] > least[i] && (widest < 0 || widths[i] > widths[widest])) {
        widest = i;
      }
    }
    return widest;
  }

  /** The lines of a row. */
  private static List<String> folded(List<String> row, int[] widths) {
    List<List<String>> cells =
        IntStream.range(0, widths.length)
            .mapToObj(
                i ->
                    i == 0 ? indented(row.get(0), widths[0]) : TextWrap.wrap(row.get(i), widths[i]))
            .toList();
    int height = cells.stream().mapToInt(List::size).max().orElse(0);
    List<String> lines = new ArrayList<>();
    for (int line = 0; line < height; line++) {
      StringBuilder text = new StringBuilder();
      for (int i = 0; i < widths.length; i++) {
        List<String> cell = cells.get(i);
        text.append(i == 0 ? "" : GAP)
            .append(TextWrap.padded(line < cell.size() ? cell.get(line) : "", widths[i]));
      }
      lines.add(text.toString().stripTrailing());
    }
    return lines;
  }

  /**
   * A first cell, whose continuation lines are indented if there is space: part of a name must not
   * look like a separate line.
   */
  private static List<String> indented(String cell, int width) {
    List<String> pieces = TextWrap.wrap(cell, width);
    if (pieces.size() == 1) {
      return pieces;
    }
    pieces = TextWrap.wrap(cell, Math.max(1, width - GAP.length()));
    List<String> lines = new ArrayList<>(pieces.subList(0, 1));
    for (String piece : pieces.subList(1, pieces.size())) {
      int available = Math.max(0, Math.min(GAP.length(), width - TextWrap.width(piece)));
      lines.add(" ".repeat(available) + piece);
    }
    return lines;
  }

  /** Each cell in a line of its own, after its heading; the headings' line stays the first. */
  private List<String> paragraphs(int columns) {
    int name = headings.stream().mapToInt(TextWrap::width).max().orElse(0);
    int available = Math.max(1, columns - name - GAP.length());
    List<String> lines = new ArrayList<>(TextWrap.wrap(String.join(GAP, headings), columns));
    for (List<String> row : rows) {
      for (int i = 0; i < row.size(); i++) {
        String heading = headings.get(i);
        for (String piece : TextWrap.wrap(row.get(i), available)) {
          lines.add((TextWrap.padded(heading, name) + GAP + piece).stripTrailing());
          heading = "";
        }
      }
      lines.add("");
    }
    lines.remove(lines.size() - 1);
    return lines;
  }
}
