package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** The legend of colours and strokes: in as many lines below a plot as it takes. */
final class Legend {

  private static final int LINE_HEIGHT = 18;
  private static final int SAMPLE = 26;
  private static final int GAP = 6;
  private static final int BETWEEN = 18;
  private static final int POINT = 7;

  private final List<List<Entry>> lines = new ArrayList<>();

  /** The labels of a path's marks: its start, an arrow and its end. */
  private static final String PATH_KEY = "start, direction, end";

  private static final int KEY = 44; // width of these marks

  /** The symbol before an entry's text; the given position is its left end, in pixels. */
  @FunctionalInterface
  private interface Sample {
    void paint(Graphics2D g, double x, double y);
  }

  private record Entry(String text, int sample, Sample painter) {

    double width() {
      return sample + GAP + PanelText.width(text, PanelText.PLAIN);
    }
  }

  /**
   * @param all each distinct non-empty name gets an entry, in this order
   * @param hasWays whether paths among them have marks, which are explained
   * @param width in pixels; a longer name is cut
   */
  Legend(List<Series> all, boolean hasWays, double width) {
    List<Entry> entries = new ArrayList<>();
    List<String> names = names(all);
    for (String name : names) {
      Series first =
          all.stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
      int number = names.indexOf(name);
      entries.add(
          new Entry(
              PanelText.fitting(name, PanelText.PLAIN, width - SAMPLE - GAP),
              SAMPLE,
              (g, x, y) -> sample(g, first, number, x, y)));
    }
    if (hasWays) {
      entries.add(
          new Entry(
              PanelText.fitting(PATH_KEY, PanelText.PLAIN, width - KEY - GAP),
              KEY,
              (g, x, y) -> PathArrows.paintKey(g, x + GAP, x + KEY - GAP, y)));
    }
    double used = Double.POSITIVE_INFINITY;
    for (Entry entry : entries) {
      if (used + BETWEEN + entry.width() > width) {
        lines.add(new ArrayList<>());
        used = -BETWEEN;
      }
      lines.get(lines.size() - 1).add(entry);
      used += BETWEEN + entry.width();
    }
  }

  /** The distinct names; a name's index determines its colour. */
  static List<String> names(List<Series> all) {
    return all.stream().map(Series::name).filter(name -> !name.isEmpty()).distinct().toList();
  }

  /** In pixels; 0 if there are no names. */
  int height() {
    return lines.isEmpty() ? 0 : lines.size() * LINE_HEIGHT + GAP;
  }

  /**
   * Paints its lines below one another.
   *
   * @param middle of them, in pixels from the left
   * @param top in pixels
   */
  void paint(Graphics2D g, double middle, double top) {
    double y = top + LINE_HEIGHT / 2.0;
    for (List<Entry> line : lines) {
      double width = line.stream().mapToDouble(Entry::width).sum() + BETWEEN * (line.size() - 1.0);
      double x = middle - width / 2;
      for (Entry each : line) {
        each.painter().paint(g, x, y);
        double baseline = y + PanelText.height(PanelText.PLAIN) / 2;
        PanelText.paint(
            g,
            each.text(),
            PanelText.PLAIN,
            Palette.INK,
            x + each.sample() + GAP,
            baseline,
            PanelText.Side.LEFT);
        x += each.width() + BETWEEN;
      }
      y += LINE_HEIGHT;
    }
  }

  private static void sample(Graphics2D g, Series first, int number, double x, double y) {
    Color full = Palette.colour(number);
    Color colour = first.isFaint() ? Palette.faint(full) : full;
    g.setColor(colour);
    g.setStroke(Palette.stroke(number));
    switch (first.style()) {
      case LINE, STEPS -> g.draw(new Line2D.Double(x, y, x + SAMPLE, y));
      case POINTS ->
          g.fill(new Ellipse2D.Double(x + (SAMPLE - POINT) / 2.0, y - POINT / 2.0, POINT, POINT));
      case AREA -> {
        Rectangle2D box = new Rectangle2D.Double(x + GAP, y - GAP, SAMPLE - 2.0 * GAP, 2 * GAP);
        g.setColor(Palette.fill(full));
        g.fill(box);
        g.setColor(colour);
        g.draw(box);
      }
    }
  }
}
