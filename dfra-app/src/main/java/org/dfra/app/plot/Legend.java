package org.dfra.app.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** What colours and strokes stand for: in as many lines below a plot as it takes. */
final class Legend {

  private static final int LINE_HEIGHT = 18;
  private static final int SAMPLE = 26;
  private static final int GAP = 6;
  private static final int BETWEEN = 18;
  private static final int POINT = 7;

  private final List<List<Entry>> lines = new ArrayList<>();

  private record Entry(String text, Series.Style style, boolean isFaint, int number) {

    double width() {
      return SAMPLE + GAP + Letters.width(text, Letters.PLAIN);
    }
  }

  /**
   * @param all of whose names those that are not empty are told once each, in this order
   * @param width in pixels; a name that is longer is cut
   */
  Legend(List<Series> all, double width) {
    List<String> names = names(all);
    double used = Double.POSITIVE_INFINITY;
    for (String name : names) {
      Series first =
          all.stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
      Entry entry =
          new Entry(
              Letters.fitting(name, Letters.PLAIN, width - SAMPLE - GAP),
              first.style(),
              first.isFaint(),
              names.indexOf(name));
      if (used + BETWEEN + entry.width() > width) {
        lines.add(new ArrayList<>());
        used = -BETWEEN;
      }
      lines.get(lines.size() - 1).add(entry);
      used += BETWEEN + entry.width();
    }
  }

  /** The names, each once; what number a name has decides on its colour. */
  static List<String> names(List<Series> all) {
    return all.stream().map(Series::name).filter(name -> !name.isEmpty()).distinct().toList();
  }

  /** In pixels; 0 where there are no names. */
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
        sample(g, each, x, y);
        double baseline = y + Letters.height(Letters.PLAIN) / 2;
        Letters.paint(
            g,
            each.text(),
            Letters.PLAIN,
            Palette.INK,
            x + SAMPLE + GAP,
            baseline,
            Letters.Side.LEFT);
        x += each.width() + BETWEEN;
      }
      y += LINE_HEIGHT;
    }
  }

  private static void sample(Graphics2D g, Entry entry, double x, double y) {
    Color full = Palette.colour(entry.number());
    Color colour = entry.isFaint() ? Palette.faint(full) : full;
    g.setColor(colour);
    g.setStroke(Palette.stroke(entry.number()));
    switch (entry.style()) {
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
