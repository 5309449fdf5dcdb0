package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A table whose rows and columns are combinations of factors: each cell has a word, and equal words
 * have one colour. The headings of the rows and columns are those of the factors; the last factor
 * changes fastest.
 */
public final class MatrixPanel implements Panel {

  private static final int MARGIN = 14;
  private static final int TITLE_HEIGHT = 26;
  private static final int LINE_HEIGHT = 22;
  private static final int HEADING_WIDTH = 96;
  private static final int GAP = 4;

  private final String title;
  private final List<Factor> rows;
  private final List<Factor> columns;
  private final List<List<Cell>> cells;

  /**
   * One of the combined quantities.
   *
   * @param name its name
   * @param values all its values, in their order
   */
  public record Factor(String name, List<String> values) {

    public Factor {
      values = List.copyOf(values);
    }
  }

  /**
   * The content of a cell.
   *
   * @param text empty for an empty cell
   * @param part position in the colour scale: from 0 to 1 for the first to the last possible value
   * @param isAroundZero whether the scale is symmetric about a middle
   */
  public record Cell(String text, double part, boolean isAroundZero) {

    /** An empty cell. */
    public static final Cell EMPTY = new Cell("", Double.NaN, false);

    Color colour() {
      if (Double.isNaN(part)) {
        return Palette.PAPER;
      }
      return (isAroundZero ? ColourScale.AROUND_ZERO : ColourScale.RISING).tint(part);
    }
  }

  /**
   * @param rows the factors whose combinations are the rows
   * @param columns the factors whose combinations are the columns
   * @param cells rows of cells, one for each combination
   */
  public MatrixPanel(
      String title, List<Factor> rows, List<Factor> columns, List<List<Cell>> cells) {
    this.title = title;
    this.rows = List.copyOf(rows);
    this.columns = List.copyOf(columns);
    this.cells = cells.stream().map(List::copyOf).toList();
    int high = combinations(rows);
    int wide = combinations(columns);
    if (cells.size() != high || cells.stream().anyMatch(row -> row.size() != wide)) {
      throw new IllegalArgumentException(
          "the matrix " + title + " needs " + high + " rows of " + wide + " cells");
    }
  }

  private static int combinations(List<Factor> factors) {
    return factors.stream().mapToInt(each -> each.values().size()).reduce(1, (a, b) -> a * b);
  }

  /** Required height, in pixels. */
  public int height() {
    return top() + cells.size() * LINE_HEIGHT + MARGIN;
  }

  /** The top of the cells: below a line for each column factor, and one for the rows' names. */
  private int top() {
    return TITLE_HEIGHT + (columns.size() + 1) * LINE_HEIGHT;
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    PanelText.paint(
        g,
        PanelText.fitting(title, PanelText.HEADING, width - 2.0 * MARGIN),
        PanelText.HEADING,
        Palette.INK,
        MARGIN,
        TITLE_HEIGHT - 8,
        PanelText.Side.LEFT);
    double left = MARGIN + (double) HEADING_WIDTH * rows.size();
    double top = top();
    double wide = (width - MARGIN - left) / combinations(columns);
    paintColumnHeadings(g, left, wide);
    paintRowHeadings(g);
    for (int row = 0; row < cells.size(); row++) {
      for (int column = 0; column < cells.get(row).size(); column++) {
        Cell cell = cells.get(row).get(column);
        box(
            g,
            new Rectangle2D.Double(
                left + column * wide, top + row * LINE_HEIGHT, wide, LINE_HEIGHT),
            cell.colour(),
            cell.text(),
            true);
      }
    }
  }

  private void paintColumnHeadings(Graphics2D g, double left, double wide) {
    int span = combinations(columns);
    for (int level = 0; level < columns.size(); level++) {
      Factor factor = columns.get(level);
      span /= factor.values().size();
      double y = TITLE_HEIGHT + (double) level * LINE_HEIGHT;
      name(g, factor.name(), left - GAP, y, left - MARGIN, PanelText.Side.RIGHT);
      for (int i = 0; i < combinations(columns) / span; i++) {
        Rectangle2D box =
            new Rectangle2D.Double(left + i * span * wide, y, span * wide, LINE_HEIGHT);
        String value = factor.values().get(i % factor.values().size());
        box(g, box, Palette.HEAD, value, false);
      }
    }
  }

  private void paintRowHeadings(Graphics2D g) {
    double top = top();
    int span = combinations(rows);
    for (int level = 0; level < rows.size(); level++) {
      Factor factor = rows.get(level);
      span /= factor.values().size();
      double x = MARGIN + (double) level * HEADING_WIDTH;
      name(g, factor.name(), x + GAP, top - LINE_HEIGHT, HEADING_WIDTH, PanelText.Side.LEFT);
      for (int i = 0; i < combinations(rows) / span; i++) {
        Rectangle2D box =
            new Rectangle2D.Double(
                x, top + i * span * LINE_HEIGHT, HEADING_WIDTH, span * (double) LINE_HEIGHT);
        box(g, box, Palette.HEAD, factor.values().get(i % factor.values().size()), false);
      }
    }
  }

  private static void name(
      Graphics2D g, String text, double x, double y, double available, PanelText.Side side) {
    String fitting = PanelText.fitting(text, PanelText.STRONG, available - 2.0 * GAP);
    double baseline = y + (LINE_HEIGHT + PanelText.height(PanelText.STRONG)) / 2;
    PanelText.paint(g, fitting, PanelText.STRONG, Palette.INK, x, baseline, side);
  }

  private static void box(
      Graphics2D g, Rectangle2D box, Color colour, String text, boolean isSmall) {
    g.setColor(colour);
    g.fill(box);
    g.setColor(Palette.FAINT);
    g.setStroke(Palette.THIN);
    g.draw(box);
    var font = isSmall ? PanelText.SMALL : PanelText.PLAIN;
    PanelText.paint(
        g,
        PanelText.fitting(text, font, box.getWidth() - GAP),
        font,
        Palette.INK,
        box.getCenterX(),
        box.getCenterY() + PanelText.height(font) / 2,
        PanelText.Side.MIDDLE);
  }

  /** The value indices of each factor in each combination. */
  public static List<int[]> combinationsOf(List<Factor> factors) {
    int all = combinations(factors);
    return IntStream.range(0, all)
        .mapToObj(
            number -> {
              int[] places = new int[factors.size()];
              int rest = number;
              for (int i = factors.size() - 1; i >= 0; i--) {
                int count = factors.get(i).values().size();
                places[i] = rest % count;
                rest /= count;
              }
              return places;
            })
        .toList();
  }
}
