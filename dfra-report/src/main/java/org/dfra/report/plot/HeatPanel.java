package org.dfra.report.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * A value over two quantities as colours, with a colour bar; lines and points can be drawn above.
 * Cells without a number are grey. Confined to one thread until it is painted.
 */
public final class HeatPanel implements Panel {

  private static final int LEVELS = 64;
  private static final int BAR = 14;
  private static final int BAR_GAP = 2;
  private static final int BAR_ROOM = 74;
  private static final int BAR_TITLE = 130;
  private static final int TICK = 4;

  private final String title;
  private final Axis x;
  private final Axis y;
  private final Axis value;
  private final double[][] cells;
  private final List<Series> above = new ArrayList<>();
  private boolean isMap;
  private String missing = "";
  private List<String> names = List.of();

  /**
   * @param x to the right, with fixed ends
   * @param y upwards, with fixed ends
   * @param value the quantity that the colours show
   * @param cells rows from the low end of y upwards, of cells from the low end of x on; all have
   *     the same size, and together they fill the axes
   */
  public HeatPanel(String title, Axis x, Axis y, Axis value, double[][] cells) {
    if (Double.isNaN(x.high() - x.low()) || Double.isNaN(y.high() - y.low())) {
      throw new IllegalArgumentException(
          "the axes " + x.label() + " and " + y.label() + " of a heat map want fixed ends");
    }
    if (cells.length == 0 || cells[0].length == 0) {
      throw new IllegalArgumentException("the heat map " + title + " has no cells");
    }
    for (double[] row : cells) {
      if (row.length != cells[0].length) {
        throw new IllegalArgumentException(
            "rows of the heat map " + title + " have " + row.length + " and " + cells[0].length);
      }
    }
    this.title = title;
    this.x = x;
    this.y = y;
    this.value = value;
    this.cells = Arrays.stream(cells).map(double[]::clone).toArray(double[][]::new);
  }

  /** Adds series above the colours. */
  public HeatPanel add(Series... series) {
    above.addAll(Arrays.asList(series));
    return this;
  }

  /** Gives both axes the same scale. */
  public HeatPanel asMap() {
    isMap = true;
    return this;
  }

  /** Sets the label of cells without a number, a few words. */
  public HeatPanel whereMissing(String meaning) {
    missing = meaning;
    return this;
  }

  /**
   * Sets the labels of the cells' values if these are integers from 0.
   *
   * @param meanings of 0, 1 and so on, a word or two each
   */
  public HeatPanel whereNumbersMean(String... meanings) {
    names = List.of(meanings);
    return this;
  }

  @Override
  public void paint(Graphics2D g, int width, int height) {
    Range range =
        names.isEmpty()
            ? value.over(Range.of(numbers(), 0))
            : new Range(-0.5, names.size() - 0.5); // each number in the middle of its colour
    Plot plot =
        new Plot(
            title,
            x,
            y,
            above,
            (canvas, painted) -> paintCells(canvas, painted, range),
            width - BAR_ROOM,
            height);
    Range across = new Range(x.low(), x.high());
    Range up = new Range(y.low(), y.high());
    plot.show(across, up);
    if (isMap) {
      PathPanel.equalise(plot, across, up);
    }
    plot.paint(
        g,
        (canvas, painted) -> {
          paintMeaning(canvas, painted.area());
          paintBar(canvas, painted.area(), range);
        });
  }

  private DoubleStream numbers() {
    return Arrays.stream(cells).flatMapToDouble(Arrays::stream);
  }

  private void paintCells(Graphics2D g, Plot plot, Range range) {
    ColourScale shades = shades(range);
    // Antialiased edges of adjacent rectangles would show the background between them.
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    Path2D[] levels = levels(plot, range);
    for (int level = 0; level <= LEVELS; level++) {
      if (levels[level].getCurrentPoint() != null) {
        g.setColor(level == LEVELS ? Palette.FAINT : colour(shades, level));
        g.fill(levels[level]);
      }
    }
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
  }

  /** The rectangles of each colour, and last those of missing values. */
  private Path2D[] levels(Plot plot, Range range) {
    Path2D[] levels = new Path2D[LEVELS + 1];
    Arrays.setAll(levels, i -> new Path2D.Double());
    Map<Run, Integer> open = new LinkedHashMap<>(); // with the row in which each began
    for (int row = 0; row <= cells.length; row++) {
      Map<Run, Integer> here = new LinkedHashMap<>();
      for (Run run : row == cells.length ? List.<Run>of() : runs(cells[row], range)) {
        @Nullable Integer began = open.remove(run);
        here.put(run, began == null ? row : began);
      }
      int end = row;
      open.forEach(
          (run, began) -> levels[run.level()].append(rectangle(plot, run, began, end), false));
      open = here;
    }
    return levels;
  }

  /** Adjacent cells of one colour in a row. */
  private record Run(int begin, int end, int level) {}

  private static List<Run> runs(double[] row, Range range) {
    List<Run> runs = new ArrayList<>();
    int begin = 0;
    for (int column = 1; column <= row.length; column++) {
      int level = level(row[begin], range);
      if (column == row.length || level(row[column], range) != level) {
        runs.add(new Run(begin, column, level));
        begin = column;
      }
    }
    return runs;
  }

  private Rectangle2D rectangle(Plot plot, Run run, int firstRow, int endRow) {
    double step = (x.high() - x.low()) / cells[0].length;
    double rise = (y.high() - y.low()) / cells.length;
    double left = plot.x(x.low() + run.begin() * step);
    double right = plot.x(x.low() + run.end() * step);
    double bottom = plot.y(y.low() + firstRow * rise);
    double top = plot.y(y.low() + endRow * rise);
    return new Rectangle2D.Double(left, top, right - left, bottom - top);
  }

  private ColourScale shades(Range range) {
    return names.isEmpty() ? ColourScale.of(range) : ColourScale.RISING;
  }

  /** A colour's index in the bar: with labels there are as many colours as labels. */
  private int barLevel(int level, Range range) {
    return names.isEmpty() ? level : level(level * names.size() / LEVELS, range);
  }

  private static Color colour(ColourScale shades, int level) {
    return shades.at(level / (LEVELS - 1.0));
  }

  private static int level(double number, Range range) {
    return Double.isFinite(number)
        ? Math.max(0, Math.min(LEVELS - 1, (int) (range.part(number) * LEVELS)))
        : LEVELS;
  }

  private void paintMeaning(Graphics2D g, Rectangle2D area) {
    if (missing.isEmpty() || numbers().allMatch(Double::isFinite)) {
      return;
    }
    String text = "grey: " + missing;
    double high = PanelText.height(PanelText.SMALL);
    g.setColor(Palette.VEIL);
    g.fill(
        new Rectangle2D.Double(
            area.getX() + 2,
            area.getY() + 2,
            PanelText.width(text, PanelText.SMALL) + 8,
            high + 8));
    PanelText.paint(
        g,
        text,
        PanelText.SMALL,
        Palette.INK,
        area.getX() + 6,
        area.getY() + 6 + high,
        PanelText.Side.LEFT);
  }

  private void paintBar(Graphics2D g, Rectangle2D area, Range range) {
    double left = area.getMaxX() + BAR;
    ColourScale shades = shades(range);
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    for (int level = 0; level < LEVELS; level++) {
      double top = area.getMaxY() - area.getHeight() * (level + 1) / LEVELS;
      g.setColor(colour(shades, barLevel(level, range)));
      g.fill(new Rectangle2D.Double(left, top, BAR, area.getHeight() / LEVELS));
    }
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setStroke(Palette.THIN);
    g.setColor(Palette.GREY);
    g.draw(new Rectangle2D.Double(left, area.getY(), BAR, area.getHeight()));
    paintTicks(g, area, range, left + BAR);
    String name = PanelText.fitting(value.title(), PanelText.PLAIN, BAR_TITLE);
    PanelText.paint(
        g,
        name,
        PanelText.PLAIN,
        Palette.INK,
        Math.min(
            left + PanelText.width(name, PanelText.PLAIN), area.getMaxX() + BAR_ROOM - BAR_GAP),
        area.getY() - 2.0 * BAR_GAP - 2,
        PanelText.Side.RIGHT);
  }

  private void paintTicks(Graphics2D g, Rectangle2D area, Range range, double right) {
    double[] ticks =
        names.isEmpty()
            ? range.ticks((int) (area.getHeight() / 30))
            : IntStream.range(0, names.size()).asDoubleStream().toArray();
    for (double tick : ticks) {
      double at = area.getMaxY() - range.part(tick) * area.getHeight();
      g.setColor(Palette.GREY);
      g.draw(new Line2D.Double(right, at, right + TICK, at));
      PanelText.paint(
          g,
          names.isEmpty() ? Numerals.of(tick) : names.get((int) tick),
          PanelText.SMALL,
          Palette.INK,
          right + TICK + BAR_GAP,
          at + PanelText.height(PanelText.SMALL) / 2,
          PanelText.Side.LEFT);
    }
  }
}
