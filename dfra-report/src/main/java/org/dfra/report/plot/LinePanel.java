package org.dfra.report.plot;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import org.jspecify.annotations.Nullable;

/** Values over time, or over any other quantity. Confined to one thread until it is painted. */
public final class LinePanel implements Panel {

  private static final double MARGIN = 0.05;
  private static final BasicStroke DOTTED =
      new BasicStroke(1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_BEVEL, 10, new float[] {3, 3}, 0);
  private static final int GAP = 3;

  private final String title;
  private final Axis x;
  private final Axis y;
  private final List<Series> all = new ArrayList<>();
  private final List<Mark> marks = new ArrayList<>();

  private final List<Span> spans = new ArrayList<>();

  private final List<Note> notes = new ArrayList<>();
  private @Nullable Range shared; // with the panels above and below
  private int left; // minimum pixels beside the plot

  /** A line across the plot with its label. */
  private record Mark(boolean isMoment, double value, String label) {}

  /** A vertical line with its number in a list of events. */
  private record Note(double at, String number) {}

  /** A vertical band with its label. */
  private record Span(double from, double to, String label) {}

  /**
   * @param x the independent quantity, such as time
   * @param y the quantity of the values
   */
  public LinePanel(String title, Axis x, Axis y) {
    this.title = title;
    this.x = x;
    this.y = y;
  }

  /** Adds series; later ones are drawn above earlier ones. */
  public LinePanel add(Series... series) {
    all.addAll(Arrays.asList(series));
    return this;
  }

  /**
   * Marks the time of an event.
   *
   * @param at in the unit of the horizontal axis
   * @param label the event, in a few words
   */
  public LinePanel moment(double at, String label) {
    marks.add(new Mark(true, at, label));
    return this;
  }

  /**
   * Marks an event that is in the list beside the figure.
   *
   * @param at in the unit of the horizontal axis
   * @param number its number in that list
   */
  public LinePanel note(double at, int number) {
    notes.add(new Note(at, Integer.toString(number)));
    return this;
  }

  /**
   * Marks an interval; it is cut at the ends of the axis.
   *
   * @param from in the unit of the horizontal axis
   * @param to likewise
   * @param label of the interval, a few words
   */
  public LinePanel span(double from, double to, String label) {
    spans.add(new Span(from, to, label));
    return this;
  }

  /**
   * Marks a limit or a target of the values.
   *
   * @param at in the unit of the vertical axis
   * @param label of the limit, a few words
   */
  public LinePanel limit(double at, String label) {
    marks.add(new Mark(false, at, label));
    return this;
  }

  /**
   * Aligns panels below one another that have the same quantity on the horizontal axis: they show
   * the same range, equal values exactly below each other.
   *
   * @param width of each, in pixels
   */
  static void align(List<LinePanel> stacked, int width, int height) {
    Range all = Range.of(stacked.stream().flatMapToDouble(LinePanel::across), 0);
    stacked.forEach(each -> each.shared = all);
    int left = 0;
    for (LinePanel each : stacked) {
      each.left = 0;
      left = Math.max(left, (int) Math.ceil(each.plot(width, height).measured().getX()));
    }
    for (LinePanel each : stacked) {
      each.left = left;
    }
  }

  /** Whether it has the same quantity on the horizontal axis as another. */
  boolean isOverTheSameAs(LinePanel other) {
    return x.equals(other.x);
  }

  private DoubleStream across() {
    return all.stream().flatMapToDouble(each -> Arrays.stream(each.x()));
  }

  /** The plot to be painted, with its ranges. */
  Plot plot(int width, int height) {
    Plot plot = new Plot(title, x, y, all, this::paintMarks, width, height);
    plot.show(
        x.over(shared == null ? Range.of(across(), 0) : shared),
        y.over(Range.of(all.stream().flatMapToDouble(each -> Arrays.stream(each.y())), MARGIN)));
    plot.leaveLeft(left);
    return plot;
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    plot(width, height).paint(g, this::paintLabels);
  }

  private void paintMarks(Graphics2D g, Plot plot) {
    Plot.paper(all).paint(g, plot);
    Rectangle2D area = plot.area();
    g.setColor(Palette.BAND);
    for (Span each : spans) {
      double left = Math.max(area.getMinX(), plot.x(each.from()));
      double right = Math.min(area.getMaxX(), plot.x(each.to()));
      if (right > left) {
        g.fill(new Rectangle2D.Double(left, area.getMinY(), right - left, area.getHeight()));
      }
    }
    g.setColor(Palette.GREY);
    g.setStroke(DOTTED);
    notes.forEach(each -> upright(g, plot.x(each.at()), area));
    for (Mark each : marks) {
      if (each.isMoment()) {
        upright(g, plot.x(each.value()), area);
      } else {
        double at = plot.y(each.value());
        g.draw(new Line2D.Double(area.getMinX(), at, area.getMaxX(), at));
      }
    }
  }

  private static void upright(Graphics2D g, double at, Rectangle2D area) {
    g.draw(new Line2D.Double(at, area.getMinY(), at, area.getMaxY()));
  }

  /** Above the series, each on a background of its own, so that they are readable. */
  private void paintLabels(Graphics2D g, Plot plot) {
    Rectangle2D area = plot.area();
    paintUprights(g, plot);
    for (Mark each : marks) {
      if (!each.isMoment()) {
        double length = PanelText.width(each.label(), PanelText.SMALL);
        AffineTransform before = g.getTransform();
        g.translate(area.getMaxX() - GAP - length, plot.y(each.value()) - GAP);
        label(g, each.label(), length);
        g.setTransform(before);
      }
    }
    paintNumbers(g, plot);
  }

  /** A vertical label, left of a position and below another one, in pixels. */
  private record Upright(double at, double top, double bottom, String label) {}

  /**
   * A label that would overlap another is moved below it. It is omitted if it has the same text or
   * there is no space below.
   */
  private void paintUprights(Graphics2D g, Plot plot) {
    Rectangle2D area = plot.area();
    double thick = PanelText.height(PanelText.SMALL) + GAP;
    List<Upright> painted = new ArrayList<>();
    for (Mark each : uprights(plot)) {
      double top = area.getMinY() + GAP;
      boolean isSaid = false;
      for (Upright other : painted) {
        if (each.value() - other.at() < thick) {
          top = Math.max(top, other.bottom() + GAP);
          isSaid |= each.label().equals(other.label());
        }
      }
      double bottom = top + PanelText.width(each.label(), PanelText.SMALL);
      if (!isSaid && (bottom <= area.getMaxY() || painted.isEmpty())) {
        upwards(g, each.value(), bottom, each.label());
        painted.add(new Upright(each.value(), top, bottom, each.label()));
      }
    }
  }

  /** Marks with vertical labels, from the left, at positions in pixels. */
  private List<Mark> uprights(Plot plot) {
    Rectangle2D area = plot.area();
    List<Mark> uprights = new ArrayList<>();
    for (Span each : spans) {
      double right = Math.min(area.getMaxX(), plot.x(each.to()));
      if (right > area.getMinX() && plot.x(each.from()) < area.getMaxX()) {
        uprights.add(new Mark(true, right, each.label()));
      }
    }
    for (Mark each : marks) {
      if (each.isMoment()) {
        uprights.add(new Mark(true, plot.x(each.value()), each.label()));
      }
    }
    uprights.sort(Comparator.comparingDouble(Mark::value));
    return uprights;
  }

  /** At the upper ends of their lines; below the last number if there is no space beside it. */
  private void paintNumbers(Graphics2D g, Plot plot) {
    double thick = PanelText.height(PanelText.SMALL) + GAP;
    double taken = Double.NEGATIVE_INFINITY;
    int level = 0;
    for (Note each : notes.stream().sorted(Comparator.comparingDouble(Note::at)).toList()) {
      double wide = PanelText.width(each.number(), PanelText.SMALL);
      double left = plot.x(each.at()) - wide / 2;
      level = left > taken ? 0 : level + 1;
      taken = left + wide + 2 * GAP;
      AffineTransform before = g.getTransform();
      g.translate(left, plot.area().getMinY() + (level + 1) * thick);
      label(g, each.number(), wide);
      g.setTransform(before);
    }
  }

  /** Left of a vertical line. */
  private static void upwards(Graphics2D g, double at, double bottom, String text) {
    AffineTransform before = g.getTransform();
    g.translate(at - GAP, bottom);
    g.rotate(-Math.PI / 2);
    label(g, text, PanelText.width(text, PanelText.SMALL));
    g.setTransform(before);
  }

  private static void label(Graphics2D g, String text, double length) {
    double thick = PanelText.height(PanelText.SMALL);
    g.setColor(Palette.VEIL);
    g.fill(new Rectangle2D.Double(-1, -thick - 1, length + 2, thick + 2));
    PanelText.paint(g, text, PanelText.SMALL, Palette.INK, 0, 0, PanelText.Side.LEFT);
  }
}
