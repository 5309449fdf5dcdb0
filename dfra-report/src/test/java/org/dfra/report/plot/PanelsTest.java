package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PanelsTest {

  private static final Axis TIME = Axis.of("time", "s");
  private static final Axis EAST = Axis.of("east", "m");
  private static final Axis NORTH = Axis.of("north", "m");

  @ParameterizedTest
  @CsvSource({"0, 1", "-1e6, 1e6", "-3e-7, 2e-7", "101325, 101325", "1.7e9, 1.7000001e9", "0, 0"})
  void keepsEverythingInsideAndIsLabelledForAnyRange(double low, double high) {
    LinePanel panel =
        new LinePanel("A title that is long enough to need most of the width", TIME, EAST);
    for (int i = 0; i < 9; i++) {
      panel.add(
          Series.line(
              "a series with a long name, number " + i,
              new double[] {low, high},
              new double[] {low, high}));
    }
    BufferedImage image = Bitmaps.of(panel, 420, 300, 10);
    assertThat(Bitmaps.inkAtEdge(image, 12)).as("pixels inked at the panel's edge").isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"30, 18, 580, 460", "3, 400, 580, 300", "1000, 1, 380, 460", "0, 0, 300, 300"})
  void aMetreIsAsLongOnBothAxesOfPaths(double wide, double high, int width, int height) {
    List<Series> all = List.of(Series.line("a", new double[] {0, wide}, new double[] {0, high}));
    Plot plot = new Plot("", EAST, NORTH, all, Plot.paper(all), width, height);
    Range across = new Range(-1, wide + 1);
    Range up = new Range(-1, high + 1);
    PathPanel.equalise(plot, across, up);
    Rectangle2D area = plot.measured();
    double metreAcross = plot.x(1) - plot.x(0);
    double metreUp = plot.y(0) - plot.y(1);
    // XChart lays plots out in whole pixels, which are up to 1 % of the metres here.
    assertThat(metreAcross).isCloseTo(metreUp, within(0.01 * metreUp));
    assertThat(plot.x(-1)).isGreaterThanOrEqualTo(area.getMinX() - 1);
    assertThat(plot.x(wide + 1)).isLessThanOrEqualTo(area.getMaxX() + 1);
    assertThat(plot.y(high + 1)).isGreaterThanOrEqualTo(area.getMinY() - 1);
  }

  @Test
  void numbersOfOnePlaceStandBesideEachOther() {
    PathPanel panel =
        new PathPanel("", EAST, NORTH)
            .add(Series.points("", new double[] {0, 10}, new double[] {0, 10}));
    for (int i = 1; i <= 20; i++) {
      panel.note(5, 5, i);
    }
    String svg = new Page("").row(400, panel).svg();
    Matcher disc = Pattern.compile("cx=\"([^\"]*)\"\\s+cy=\"([^\"]*)\"[^>]*r=\"9\"").matcher(svg);
    assertThat(disc.results().map(each -> each.group(1) + each.group(2)).distinct())
        .as(svg)
        .hasSize(20);
  }

  @Test
  void pathsWantOneUnit() {
    assertThatThrownBy(() -> new PathPanel("", EAST, Axis.of("north", "km")))
        .hasMessage("equal axes want one unit, not m and km");
  }

  @Test
  void aMissingPointInterruptsTheLine() {
    double[] x = {0, 1, 2, 3, 4};
    long whole = inked(Series.line("a", x, new double[] {1, 1, 1, 1, 1}));
    long missing = inked(Series.line("a", x, new double[] {1, 1, Double.NaN, 1, 1}));
    assertThat(missing).isBetween(whole / 3, whole * 2 / 3);
    long noPlace = inked(Series.line("a", new double[] {0, 1, Double.NaN, 3, 4}, x));
    assertThat(noPlace).isPositive();
  }

  /** Pixels of the first colour, those in the legend left out. */
  private static long inked(Series series) {
    LinePanel panel = new LinePanel("", TIME.between(0, 4), EAST.between(0, 4)).add(series);
    long all = Bitmaps.count(Bitmaps.of(panel, 400, 300, 0), Palette.colour(0));
    LinePanel legend =
        new LinePanel("", TIME.between(0, 4), EAST.between(0, 4))
            .add(Series.line("a", new double[] {9, 9}, new double[] {9, 9}));
    return all - Bitmaps.count(Bitmaps.of(legend, 400, 300, 0), Palette.colour(0));
  }

  @Test
  void seriesOfOneNameHaveOneColourAndNamelessOnesAreGrey() {
    PathPanel panel =
        new PathPanel("", EAST.between(0, 10), NORTH.between(0, 10))
            .add(
                Series.line("post", new double[] {1, 2}, new double[] {1, 1}),
                Series.line("post", new double[] {3, 4}, new double[] {1, 1}),
                Series.line("", new double[] {5, 9}, new double[] {5, 5}));
    BufferedImage image = Bitmaps.of(panel, 400, 300, 0);
    assertThat(Bitmaps.count(image, Palette.colour(0))).isPositive();
    assertThat(Bitmaps.count(image, Palette.GREY)).isPositive();
    assertThat(Bitmaps.count(image, Palette.colour(1))).isZero();
  }

  @Test
  void refusesSeriesWhoseHalvesDiffer() {
    assertThatThrownBy(() -> Series.line("a", new double[2], new double[3]))
        .hasMessage("the series a has 2 x and 3 y");
  }

  @Test
  void refusesAnAxisThatEndsBeforeItBegins() {
    assertThatThrownBy(() -> TIME.between(2, 1))
        .hasMessage("the axis time from 2.0 to 1.0 is empty; give low < high");
  }

  @Test
  void colourBlindReadersDistinguishTheColours() {
    for (double[][] eye : Eyes.ALL) {
      for (int i = 0; i < 7; i++) {
        assertThat(Eyes.distance(eye, Palette.colour(i), Color.WHITE))
            .as("colour %d on paper", i)
            .isGreaterThan(20);
        for (int j = 0; j < i; j++) {
          assertThat(Eyes.distance(eye, Palette.colour(i), Palette.colour(j)))
              .as("colours %d and %d", i, j)
              .isGreaterThan(9);
        }
      }
    }
  }

  @Test
  void whereColoursComeAgainTheDashesDiffer() {
    assertThat(Palette.colour(7)).isEqualTo(Palette.colour(0));
    assertThat(Palette.stroke(7).getDashArray()).isNotNull();
    assertThat(Palette.stroke(0).getDashArray()).isNull();
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "-0.25, −0.25",
    "1200, 1200",
    "3097123.4, 3097123.4",
    "1e12, 1e12",
    "-2.5e-7, −2.5e−7",
    "0.0001, 0.0001"
  })
  void writesNumbersAsPeopleDo(double value, String text) {
    assertThat(Numerals.of(value)).isEqualTo(text);
  }

  @Test
  void cutsTextThatDoesNotFit() {
    String cut = PanelText.fitting("heading error in degrees", PanelText.PLAIN, 60);
    assertThat(cut).startsWith("head").endsWith("…");
    assertThat(PanelText.width(cut, PanelText.PLAIN)).isLessThanOrEqualTo(60);
    assertThat(PanelText.fitting("short", PanelText.PLAIN, 60)).isEqualTo("short");
  }

  @Test
  void aSpanIsABandThatIsCutAtTheAxis() {
    double[] time = {0, 10};
    LinePanel plain = new LinePanel("", TIME, EAST).add(Series.line("", time, time));
    LinePanel marked =
        new LinePanel("", TIME, EAST).add(Series.line("", time, time)).span(5, 99, "silent");
    LinePanel beyond =
        new LinePanel("", TIME, EAST).add(Series.line("", time, time)).span(98, 99, "silent");
    Color band = new Color(0xE4, 0xE4, 0xE4); // what is seen of it on paper
    long ofGrid = Bitmaps.count(Bitmaps.of(plain, 400, 200, 10), band);
    assertThat(ofGrid).isLessThan(1_000);
    // half of a plot some 360 by 140 pixels large, less grid and label
    assertThat(Bitmaps.count(Bitmaps.of(marked, 400, 200, 10), band)).isBetween(15_000L, 30_000L);
    assertThat(Bitmaps.inkAtEdge(Bitmaps.of(marked, 400, 200, 10), 12)).isEmpty();
    assertThat(Bitmaps.count(Bitmaps.of(beyond, 400, 200, 10), band)).isEqualTo(ofGrid);
    assertThat(new Page("").row(200, marked).svg()).contains(">silent<");
    assertThat(new Page("").row(200, beyond).svg()).doesNotContain(">silent<");
  }

  @Test
  void numbersThatWouldCoverEachOtherStandBelowEachOther() {
    double[] time = {0, 10};
    LinePanel panel = new LinePanel("", TIME, EAST).add(Series.line("", time, time));
    panel.note(2, 101).note(2.01, 102).note(2.02, 103).note(8, 104);
    String svg = new Page("").row(200, panel).svg();
    List<Double> heights =
        Stream.of("101", "102", "103", "104").map(number -> heightOf(svg, number)).toList();
    assertThat(heights.get(1)).isGreaterThan(heights.get(0) + 5);
    assertThat(heights.get(2)).isGreaterThan(heights.get(1) + 5);
    assertThat(heights.get(3)).isCloseTo(heights.get(0), within(0.01));
    assertThat(Bitmaps.inkAtEdge(Bitmaps.of(panel, 400, 200, 10), 12)).isEmpty();
  }

  /** How far below the top a text is, pixels: by the transforms of the element that holds it. */
  private static double heightOf(String svg, String text) {
    String before = svg.substring(0, svg.indexOf(">" + text + "<"));
    String transform = before.substring(before.lastIndexOf("transform=\""));
    return Pattern.compile("(?:matrix\\(1,0,0,1,|translate\\()[\\d.]+,([\\d.]+)\\)")
        .matcher(transform)
        .results()
        .mapToDouble(each -> Double.parseDouble(each.group(1)))
        .sum();
  }

  @Test
  void uprightLabelsDoNotLieOnOneAnother() {
    double[] both = {0, 100};
    LinePanel panel =
        new LinePanel("", Axis.of("time", "s"), Axis.of("off", "m"))
            .add(Series.line("off", both, both))
            .span(10, 10.5, "front silent")
            .span(10.6, 11, "front silent")
            .span(10.7, 11.2, "rear silent")
            .span(60, 61, "rear silent");
    String svg = new Page("").row(300, panel).svg();
    assertThat(svg.split(">front silent<", -1)).as("said once of both").hasSize(2);
    assertThat(svg.split(">rear silent<", -1)).hasSize(3);
    List<Double> bottoms =
        Pattern.compile("(?:0,-1,1,0,|translate\\()[\\d.]+,([\\d.]+)\\)[^>]*>[^>]*>\\w+ silent<")
            .matcher(svg)
            .results()
            .map(each -> Double.valueOf(each.group(1)))
            .toList();
    assertThat(bottoms).hasSize(3);
    assertThat(bottoms.get(1)).as("below the one beside it").isGreaterThan(bottoms.get(0) + 40);
    assertThat(bottoms.get(2)).as("alone, so at the top").isLessThan(bottoms.get(0));
  }

  @Test
  void theLegendSaysWhatTheMarksOfAPathMean() {
    double[] both = {0, 10};
    String key = ">start, direction, end<";
    Series way = Series.line("robot", both, both);
    assertThat(new Page("").row(300, new PathPanel("", EAST, NORTH).addPath(way)).svg())
        .contains(key);
    assertThat(new Page("").row(300, new PathPanel("", EAST, NORTH).add(way)).svg())
        .as("a line without marks")
        .doesNotContain(key);
  }

  @Test
  void aFaintSeriesIsPalerAndHasItsPlaceInTheLegend() {
    double[] both = {0, 10};
    PathPanel panel = new PathPanel("", EAST, NORTH).add(Series.line("raw", both, both).faint());
    String svg = new Page("").row(300, panel).svg();
    assertThat(svg).contains(">raw<");
    assertThat(Bitmaps.count(Bitmaps.of(panel, 300, 300, 10), Palette.colour(0))).isZero();
  }
}
