package org.dfra.report.plot;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;

/** Lines of text below a title, in columns; long lines are wrapped and indented. */
public final class TextPanel implements Panel {

  private static final int MARGIN = 14;
  private static final int TITLE_HEIGHT = 24;
  private static final int LINE_HEIGHT = 17;
  private static final int INDENT = 22;

  private final String title;
  private final List<String> lines;
  private final int columns;

  /**
   * @param columns number of columns; the first is filled first
   */
  public TextPanel(String title, List<String> lines, int columns) {
    this.title = title;
    this.lines = List.copyOf(lines);
    this.columns = columns;
  }

  /** Required height for this width, in pixels. */
  public int height(int width) {
    return TITLE_HEIGHT + perColumn(broken(width)) * LINE_HEIGHT + MARGIN;
  }

  private double columnWidth(int width) {
    return (width - (columns + 1.0) * MARGIN) / columns;
  }

  private int perColumn(List<String> pieces) {
    return (pieces.size() + columns - 1) / columns;
  }

  /** The wrapped lines; continuation lines start with a tab character. */
  private List<String> broken(int width) {
    List<String> pieces = new ArrayList<>();
    for (String line : lines) {
      StringBuilder piece = new StringBuilder();
      for (String word : line.split(" ", -1)) {
        String longer = piece.isEmpty() ? word : piece + " " + word;
        if (width(longer) > columnWidth(width) && !piece.toString().isBlank()) {
          pieces.add(piece.toString());
          piece.setLength(0);
          piece.append('\t').append(word);
        } else {
          piece.setLength(0);
          piece.append(longer);
        }
      }
      pieces.add(piece.toString());
    }
    return pieces;
  }

  private static double width(String piece) {
    return PanelText.width(piece.strip(), PanelText.PLAIN) + (piece.startsWith("\t") ? INDENT : 0);
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    PanelText.paint(
        g,
        PanelText.fitting(title, PanelText.HEADING, width - 2.0 * MARGIN),
        PanelText.HEADING,
        Palette.INK,
        MARGIN,
        TITLE_HEIGHT - 6,
        PanelText.Side.LEFT);
    List<String> pieces = broken(width);
    int perColumn = perColumn(pieces);
    for (int i = 0; i < pieces.size(); i++) {
      double x = MARGIN + i / perColumn * (columnWidth(width) + MARGIN);
      double available = columnWidth(width);
      boolean goesOn = pieces.get(i).startsWith("\t");
      PanelText.paint(
          g,
          PanelText.fitting(
              pieces.get(i).strip(), PanelText.PLAIN, available - (goesOn ? INDENT : 0)),
          PanelText.PLAIN,
          Palette.INK,
          x + (goesOn ? INDENT : 0),
          TITLE_HEIGHT + (i % perColumn + 1) * LINE_HEIGHT - 4,
          PanelText.Side.LEFT);
    }
  }
}
