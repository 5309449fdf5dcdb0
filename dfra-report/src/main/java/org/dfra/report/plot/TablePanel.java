package org.dfra.report.plot;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * Rows of cells under headings. The first column is as wide as its widest cell; the others share
 * the rest, and text that is too long is cut.
 */
public final class TablePanel implements Panel {

  private static final int MARGIN = 14;
  private static final int LINE_HEIGHT = 22;
  private static final int GAP = 8;

  private final List<List<String>> rows = new ArrayList<>();

  /**
   * @param headings of the columns
   * @param rows each with as many cells
   */
  public TablePanel(List<String> headings, List<List<String>> rows) {
    this.rows.add(List.copyOf(headings));
    for (List<String> row : rows) {
      if (row.size() != headings.size()) {
        throw new IllegalArgumentException(
            row.size() + " cells in a table of " + headings.size() + " columns");
      }
      this.rows.add(List.copyOf(row));
    }
  }

  /** Required height, in pixels. */
  public int height() {
    return rows.size() * LINE_HEIGHT + MARGIN;
  }

  /** Whether a column has numbers, which are right-aligned. */
  private boolean isNumbers(int column) {
    return Numerals.areNumbers(rows.stream().skip(1).map(row -> row.get(column)).toList());
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    double first =
        2 * GAP
            + rows.stream()
                .mapToDouble(row -> PanelText.width(row.get(0), PanelText.PLAIN))
                .max()
                .orElse(0);
    double other = (width - 2.0 * MARGIN - first) / Math.max(1, rows.get(0).size() - 1);
    boolean[] isRight = new boolean[rows.get(0).size()];
    for (int column = 0; column < isRight.length; column++) {
      isRight[column] = isNumbers(column);
    }
    g.setColor(Palette.HEAD);
    g.fill(new Rectangle2D.Double(MARGIN, 0, width - 2.0 * MARGIN, LINE_HEIGHT));
    for (int row = 0; row < rows.size(); row++) {
      double bottom = (row + 1.0) * LINE_HEIGHT;
      double left = MARGIN;
      for (int column = 0; column < rows.get(row).size(); column++) {
        double wide = column == 0 ? first : other;
        PanelText.paint(
            g,
            PanelText.fitting(rows.get(row).get(column), PanelText.PLAIN, wide - GAP),
            PanelText.PLAIN,
            Palette.INK,
            isRight[column] ? left + wide - GAP : left + GAP,
            bottom - (LINE_HEIGHT - PanelText.height(PanelText.PLAIN)) / 2,
            isRight[column] ? PanelText.Side.RIGHT : PanelText.Side.LEFT);
        left += wide;
      }
      g.setColor(Palette.FAINT);
      g.setStroke(Palette.THIN);
      g.draw(new Line2D.Double(MARGIN, bottom, width - (double) MARGIN, bottom));
    }
  }
}
