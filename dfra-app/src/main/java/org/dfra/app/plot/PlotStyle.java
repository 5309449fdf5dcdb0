package org.dfra.app.plot;

import java.awt.BasicStroke;
import java.util.Locale;
import org.knowm.xchart.style.XYStyler;

/**
 * The style of XChart's part of a plot: plain, small, and without the parts that this package
 * paints.
 */
final class PlotStyle {

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
