package org.dfra.report.plot;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import org.jspecify.annotations.Nullable;

/**
 * Positions and paths, with the same scale on both axes. Confined to one thread until it is
 * painted.
 */
public final class PathPanel implements Panel {

  private static final double MARGIN = 0.04;
  private static final int ROUNDS = 4;

  private final String title;
  private final Axis x;
  private final Axis y;
  private final List<Series> all = new ArrayList<>();
  private final List<Note> notes = new ArrayList<>();
  private final List<Series> paths = new ArrayList<>();

  /** A position with its number in a list of events. */
  private record Note(double x, double y, String number) {}

  /**
   * Both axes have the same unit. Fixed ends are always visible; one axis shows more, so that the
   * scales are equal.
   *
   * @param x to the right, such as east
   * @param y upwards, such as north
   */
  public PathPanel(String title, Axis x, Axis y) {
    if (!x.unit().equals(y.unit())) {
      throw new IllegalArgumentException(
          "equal axes want one unit, not " + x.unit() + " and " + y.unit());
    }
    this.title = title;
    this.x = x;
    this.y = y;
  }

  /** Adds series; later ones are drawn above earlier ones. */
  public PathPanel add(Series... series) {
    all.addAll(Arrays.asList(series));
    return this;
  }

  /** Adds a path with marks: its start, its end, and arrows in its direction. */
  public PathPanel addPath(Series way) {
    paths.add(way);
    return add(way);
  }

  /**
   * Marks an event that is in the list beside the figure.
   *
   * @param x in the unit of the axes
   * @param y likewise
   * @param number its number in that list
   */
  public PathPanel note(double x, double y, int number) {
    notes.add(new Note(x, y, Integer.toString(number)));
    return this;
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    Range across = x.over(Range.of(values(Series::x, Note::x), MARGIN));
    Range up = y.over(Range.of(values(Series::y, Note::y), MARGIN));
    boolean hasWays = !paths.stream().allMatch(Series::isEmpty);
    Plot plot = new Plot(title, x, y, all, hasWays, Plot.paper(all), width, height);
    equalise(plot, across, up);
    plot.paint(g, this::paintNotes);
  }

  private DoubleStream values(Function<Series, double[]> of, ToDoubleFunction<Note> at) {
    return DoubleStream.concat(
        all.stream().flatMapToDouble(each -> Arrays.stream(of.apply(each))),
        notes.stream().mapToDouble(at));
  }

  private void paintNotes(Graphics2D g, Plot plot) {
    List<String> names = Legend.names(all);
    for (Series each : paths) {
      int number = names.indexOf(each.name());
      PathArrows.paint(g, plot, each, number < 0 ? Palette.GREY : Palette.colour(number));
    }
    NumberTags tags = new NumberTags(plot.area());
    notes.forEach(each -> tags.add(plot.x(each.x()), plot.y(each.y()), each.number()));
    tags.paint(g);
  }

  /**
   * Widens one of the ranges. The plot's size depends on the width of its labels, and these on the
   * ranges, so it takes several iterations.
   */
  static void equalise(Plot plot, Range across, Range up) {
    plot.show(across, up);
    @Nullable Rectangle2D area = null;
    for (int round = 0; round < ROUNDS; round++) {
      Rectangle2D last = area;
      area = plot.measured();
      if (area.equals(last)) {
        return; // converged
      }
      double scale = Math.min(area.getWidth() / across.length(), area.getHeight() / up.length());
      plot.show(
          across.widened(area.getWidth() / scale / across.length()),
          up.widened(area.getHeight() / scale / up.length()));
    }
  }
}
