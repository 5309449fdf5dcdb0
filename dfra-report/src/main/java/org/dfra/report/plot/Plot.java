package org.dfra.report.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.XYSeries.XYSeriesRenderStyle;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/**
 * Axes with series on them, in the style of all panels: ticks, grid and series are XChart's; titles
 * and the legend are text around these.
 *
 * <pre>
 *              title
 *   y title | XChart
 *              x title
 *              legend
 * </pre>
 *
 * All positions are in pixels from the upper left corner of XChart's part.
 */
final class Plot {

  /** XChart omits the label of a tick at the very end of an axis, so axes are extended by this. */
  private static final double BEYOND_THE_END = 1e-6;

  private static final String GROUND = "ground";
  private static final int PADDING = PlotStyle.PADDING;
  private static final int TITLE = 16;
  private static final int TITLE_BASELINE = 6;
  private static final int X_BASELINE = 2;
  private static final int Y_BASELINE = 6;
  private static final Marker POINTS = points(6);
  private static final Marker FAINT_POINTS = points(4);

  private final XYChart chart;
  private final Legend legend;
  private final String title;
  private final Axis x;
  private final Axis y;
  private final int left;
  private final int top;
  private final int width;
  private final int height;
  private Range across = new Range(0, 1);
  private Range up = new Range(0, 1);

  /** Paints within a plot, below its series or above them. */
  @FunctionalInterface
  interface Layer {
    void paint(Graphics2D g, Plot plot);
  }

  /**
   * @param ground painted below the series, clipped to the plot area
   * @param wide of the panel, in pixels
   * @param high of the panel, in pixels
   */
  Plot(String title, Axis x, Axis y, List<Series> all, Layer ground, int wide, int high) {
    this(title, x, y, all, false, ground, wide, high);
  }

  /**
   * @param hasPaths whether paths among the series have marks, which the legend explains
   * @param ground painted below the series, clipped to the plot area
   * @param wide of the panel, in pixels
   * @param high of the panel, in pixels
   */
  Plot(
      String title,
      Axis x,
      Axis y,
      List<Series> all,
      boolean hasPaths,
      Layer ground,
      int wide,
      int high) {
    this.title = title;
    this.x = x;
    this.y = y;
    legend = new Legend(all, hasPaths, wide - 2.0 * PADDING);
    left = y.title().isEmpty() ? 0 : TITLE;
    top = title.isEmpty() ? 0 : TITLE;
    width = wide - left;
    height = high - top - (x.title().isEmpty() ? 0 : TITLE) - legend.height();
    chart = new XYChart(width, height);
    PlotStyle.apply(chart.getStyler());
    add(all, ground);
  }

  /**
   * A point is a very short stroke with round ends: SVG can have many of these in one path.
   *
   * @param wide in pixels
   */
  private static Marker points(float wide) {
    BasicStroke round = new BasicStroke(wide, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    return new Marker() {
      @Override
      public void paint(Graphics2D g, double x, double y, int size) {
        g.setStroke(round);
        g.draw(new Line2D.Double(x, y, x + 0.01, y));
      }
    };
  }

  /** Sets the ranges that the axes show. */
  void show(Range x, Range y) {
    across = x;
    up = y;
    Range wide = x.widened(1 + BEYOND_THE_END);
    Range high = y.widened(1 + BEYOND_THE_END);
    XYStyler styler = chart.getStyler();
    styler.setXAxisMin(wide.low());
    styler.setXAxisMax(wide.high());
    styler.setYAxisMin(high.low());
    styler.setYAxisMax(high.high());
    // If all values of an axis and its ends are evenly spaced, XChart has ticks at values only.
    // This first value prevents that: it lies at the far end.
    chart.updateXYSeries(GROUND, new double[] {x.high()}, new double[] {y.high()}, null);
  }

  private void add(List<Series> all, Layer ground) {
    // XChart paints series in the order added, inside the plot's clip: the ground is the first.
    XYSeries first = chart.addSeries(GROUND, new double[] {0}, new double[] {0});
    first.setMarker(
        new Marker() {
          @Override
          public void paint(Graphics2D g, double x, double y, int size) {
            ground.paint(g, Plot.this);
          }
        });
    List<String> names = Legend.names(all);
    for (int i = 0; i < all.size(); i++) {
      Series each = all.get(i);
      if (!each.isEmpty()) {
        XYSeries added = chart.addSeries("series" + i, each.x(), each.y());
        applyStyle(added, each, names.indexOf(each.name()));
      }
    }
  }

  /**
   * @param number of the series' name, from 0; below zero where it has none
   */
  private static void applyStyle(XYSeries series, Series reported, int number) {
    Series.Style style = reported.style();
    Color full = number < 0 ? Palette.GREY : Palette.colour(number);
    Color colour = reported.isFaint() ? Palette.faint(full) : full;
    series.setLineColor(colour);
    series.setMarkerColor(colour);
    series.setFillColor(Palette.fill(full));
    series.setLineStyle(
        style == Series.Style.POINTS ? SeriesLines.NONE : Palette.stroke(Math.max(0, number)));
    series.setMarker(
        style != Series.Style.POINTS
            ? SeriesMarkers.NONE
            : reported.isFaint() ? FAINT_POINTS : POINTS);
    series.setXYSeriesRenderStyle(
        switch (style) {
          case LINE -> XYSeriesRenderStyle.Line;
          case STEPS -> XYSeriesRenderStyle.Step;
          case POINTS -> XYSeriesRenderStyle.Scatter;
          case AREA -> XYSeriesRenderStyle.PolygonArea;
        });
  }

  /**
   * Paints the panel.
   *
   * @param over painted above the series
   */
  void paint(Graphics2D g, Layer over) {
    AffineTransform before = g.getTransform();
    g.translate(left, top);
    chart.paint(g, width, height);
    over.paint(g, this);
    paintTitles(g);
    g.setTransform(before);
  }

  private void paintTitles(Graphics2D g) {
    Rectangle2D area = area();
    double widest = left + width - 2.0 * PADDING;
    String fitting = PanelText.fitting(title, PanelText.HEADING, widest);
    double spare = (widest - PanelText.width(fitting, PanelText.HEADING)) / 2;
    double panel = (width - left) / 2.0;
    double middle = Math.max(panel - spare, Math.min(area.getCenterX(), panel + spare));
    PanelText.paint(
        g, fitting, PanelText.HEADING, Palette.INK, middle, TITLE_BASELINE, PanelText.Side.MIDDLE);
    PanelText.paint(
        g,
        PanelText.fitting(x.title(), PanelText.PLAIN, area.getWidth()),
        PanelText.PLAIN,
        Palette.INK,
        area.getCenterX(),
        height + X_BASELINE,
        PanelText.Side.MIDDLE);
    PanelText.upwards(
        g,
        PanelText.fitting(y.title(), PanelText.PLAIN, height),
        PanelText.PLAIN,
        Palette.INK,
        Y_BASELINE,
        height / 2.0);
    legend.paint(g, panel, height + (x.title().isEmpty() ? 0 : TITLE));
  }

  /** Position of a value of the horizontal axis. */
  double x(double value) {
    return chart.getScreenXFromChart(value);
  }

  /** Position of a value of the vertical axis. */
  double y(double value) {
    return chart.getScreenYFromChart(value);
  }

  /** The area between the axes. Known while and after it is painted. */
  Rectangle2D area() {
    double west = x(across.low());
    double north = y(up.high());
    return new Rectangle2D.Double(west, north, x(across.high()) - west, y(up.low()) - north);
  }

  /**
   * The area between the axes with the current ranges. Later ranges do not make it wider, however
   * short their labels are.
   */
  Rectangle2D measured() {
    Graphics2D nowhere = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
    nowhere.addRenderingHints(Page.HINTS);
    paint(nowhere, (g, plot) -> {});
    nowhere.dispose();
    Rectangle2D area = area();
    XYStyler styler = chart.getStyler();
    styler.setYAxisLeftWidthHint(
        Math.max(styler.getYAxisLeftWidthHint(), (int) Math.ceil(area.getX())));
    return area;
  }

  /** Reserves space for the labels of the vertical axis, as wide as in other panels, in pixels. */
  void leaveLeft(int pixels) {
    XYStyler styler = chart.getStyler();
    styler.setYAxisLeftWidthHint(Math.max(styler.getYAxisLeftWidthHint(), pixels));
  }

  /** A background that shows where there are no data. */
  static Layer paper(List<Series> all) {
    boolean isEmpty = all.stream().allMatch(Series::isEmpty);
    return (g, plot) -> {
      if (isEmpty) {
        Rectangle2D area = plot.area();
        PanelText.paint(
            g,
            "no data",
            PanelText.PLAIN,
            Palette.GREY,
            area.getCenterX(),
            area.getCenterY(),
            PanelText.Side.MIDDLE);
      }
    };
  }

  /**
   * The style of XChart's part of a plot: plain, small, and without the parts that this package
   * paints.
   */
  private static final class PlotStyle {

    /** Around XChart's part, in pixels; enough for half of a label at the end of an axis. */
    static final int PADDING = 14;

    private PlotStyle() {}

    static void apply(XYStyler styler) {
      styler.setLocale(Locale.ROOT);
      styler.setAxisTickLabelsFont(PanelText.SMALL);
      styler.setChartBackgroundColor(Palette.PAPER);
      styler.setChartPadding(PADDING);
      styler.setPlotBackgroundColor(Palette.PAPER);
      styler.setPlotBorderColor(Palette.GREY);
      styler.setPlotContentSize(1);
      styler.setPlotMargin(0);
      styler.setPlotGridLinesColor(Palette.FAINT);
      styler.setPlotGridLinesStroke(new BasicStroke(0.7f));
      styler.setAxisTickLabelsColor(Palette.INK);
      styler.setAxisTickMarksColor(Palette.GREY);
      styler.setAxisTicksLineVisible(false);
      styler.setXAxisTickMarkSpacingHint(60);
      styler.setYAxisTickMarkSpacingHint(36);
      styler.setXAxisTickLabelsFormattingFunction(Numerals::of);
      styler.setYAxisTickLabelsFormattingFunction(Numerals::of);
      styler.setLegendVisible(false);
    }
  }
}
