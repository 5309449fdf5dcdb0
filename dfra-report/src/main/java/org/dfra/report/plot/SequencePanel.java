package org.dfra.report.plot;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;

/**
 * A message sequence chart: a vertical line for each participant, and an arrow for each message,
 * the first on top. A broadcast has an arrow to each other line. Confined to one thread until it is
 * painted.
 */
public final class SequencePanel implements Panel {

  private static final int MARGIN = 14;
  private static final int HEAD = 26;
  private static final int ROW = 26;
  private static final int TIME_WIDTH = 60;
  private static final double TIP = 7;
  private static final BasicStroke DASHED =
      new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 10, new float[] {3, 3}, 0);

  private final List<String> lines;
  private final List<Arrow> arrows = new ArrayList<>();

  /** A message; {@code to} is negative for a broadcast. */
  private record Arrow(String time, int from, int to, String text) {}

  /**
   * @param names of the participants, from left to right; two at least
   */
  public SequencePanel(List<String> names) {
    if (names.size() < 2) {
      throw new IllegalArgumentException("it takes two to talk");
    }
    this.lines = List.copyOf(names);
  }

  /**
   * Adds a message after those before it.
   *
   * @param time when it was sent, as shown
   * @param to name of the recipient; empty for a broadcast
   * @throws IllegalArgumentException if one of them has no line
   */
  public SequencePanel message(String time, String from, String to, String text) {
    arrows.add(new Arrow(time, line(from), to.isEmpty() ? -1 : line(to), text));
    return this;
  }

  private int line(String name) {
    int line = lines.indexOf(name);
    if (line < 0) {
      throw new IllegalArgumentException(name + " is none of " + lines);
    }
    return line;
  }

  /** Required height, in pixels. */
  public int height() {
    return HEAD + (arrows.size() + 1) * ROW;
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    double separation = (width - 2.0 * MARGIN - TIME_WIDTH) / lines.size();
    double[] x = new double[lines.size()];
    for (int i = 0; i < x.length; i++) {
      x[i] = MARGIN + TIME_WIDTH + separation * (i + 0.5);
      PanelText.paint(
          g, lines.get(i), PanelText.STRONG, Palette.INK, x[i], HEAD - 8.0, PanelText.Side.MIDDLE);
      g.setColor(Palette.GREY);
      g.setStroke(DASHED);
      g.draw(new Line2D.Double(x[i], HEAD, x[i], height));
    }
    for (int row = 0; row < arrows.size(); row++) {
      paint(g, arrows.get(row), x, HEAD + (row + 1.0) * ROW);
    }
  }

  private static void paint(Graphics2D g, Arrow arrow, double[] x, double y) {
    PanelText.paint(g, arrow.time(), PanelText.SMALL, Palette.GREY, MARGIN, y, PanelText.Side.LEFT);
    g.setStroke(Palette.THIN);
    g.setColor(Palette.colour(arrow.from()));
    double nearest = x[arrow.to() < 0 ? (arrow.from() == 0 ? 1 : arrow.from() - 1) : arrow.to()];
    for (int i = 0; i < x.length; i++) {
      if (i != arrow.from() && (arrow.to() < 0 || arrow.to() == i)) {
        arrow(g, x[arrow.from()], x[i], y);
      }
    }
    double middle = (x[arrow.from()] + nearest) / 2;
    PanelText.paint(
        g, arrow.text(), PanelText.SMALL, Palette.INK, middle, y - 4, PanelText.Side.MIDDLE);
  }

  private static void arrow(Graphics2D g, double from, double to, double y) {
    g.draw(new Line2D.Double(from, y, to, y));
    double back = to > from ? -TIP : TIP;
    Path2D.Double tip = new Path2D.Double();
    tip.moveTo(to, y);
    tip.lineTo(to + back, y - TIP / 2);
    tip.lineTo(to + back, y + TIP / 2);
    tip.closePath();
    g.fill(tip);
  }
}
