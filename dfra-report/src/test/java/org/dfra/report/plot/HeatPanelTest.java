package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class HeatPanelTest {

  private static final Axis EAST = Axis.of("east", "m").between(0, 4);
  private static final Axis NORTH = Axis.of("north", "m").between(0, 2);
  private static final Axis HEIGHT = Axis.of("height", "m");

  private static double[][] slope(int rows, int columns) {
    double[][] cells = new double[rows][columns];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        cells[row][column] = row * 2 + column;
      }
    }
    return cells;
  }

  @Test
  void theFirstRowIsAtTheBottomAndTheFirstCellAtTheLeft() {
    double[][] cells = {{0, 1}, {2, 3}};
    BufferedImage image =
        Bitmaps.of(new HeatPanel("", EAST, NORTH, HEIGHT.between(0, 3), cells), 600, 300, 0);
    // Well inside the quarters of what is between the axes, which takes most of the panel.
    assertThat(new Color(image.getRGB(150, 200))).isEqualTo(ColourScale.RISING.at(0));
    assertThat(new Color(image.getRGB(400, 200))).isEqualTo(ColourScale.RISING.at(21 / 63.0));
    assertThat(new Color(image.getRGB(150, 60))).isEqualTo(ColourScale.RISING.at(42 / 63.0));
    assertThat(new Color(image.getRGB(400, 60))).isEqualTo(ColourScale.RISING.at(1));
  }

  @Test
  void cellsWithoutANumberAreGreyAndTheirMeaningIsShown() {
    double[][] cells = {{0, Double.NaN}, {2, 3}};
    HeatPanel panel = new HeatPanel("", EAST, NORTH, HEIGHT, cells).whereMissing("not seen");
    BufferedImage image = Bitmaps.of(panel, 600, 300, 0);
    assertThat(new Color(image.getRGB(400, 200))).isEqualTo(Palette.FAINT);
    assertThat(new Page("").row(300, panel).svg()).contains("grey: not seen");
    HeatPanel full = new HeatPanel("", EAST, NORTH, HEIGHT, slope(2, 2)).whereMissing("not seen");
    assertThat(new Page("").row(300, full).svg()).doesNotContain("not seen");
  }

  @ParameterizedTest
  @CsvSource({"-1, 1", "0, 3", "-180, 180", "-0.1, 0.1", "5, 1e5"})
  void axesHaveMoreThanOneTickAndNothingIsCut(double low, double high) {
    HeatPanel panel =
        new HeatPanel(
            "A surface of something",
            Axis.of("a quantity with a long name", "rad/s").between(low, high),
            Axis.of("another one", "m").between(low, high),
            Axis.of("a third one with a long name", "m/s²"),
            slope(30, 40));
    BufferedImage image = Bitmaps.of(panel, 580, 360, 10);
    assertThat(Bitmaps.inkAtEdge(image, 11)).isEmpty();
    assertThat(ticksBelow(panel)).isGreaterThan(2 * 2); // the page has it twice
  }

  /** Tick marks of the horizontal axis: short strokes upwards. */
  private static long ticksBelow(HeatPanel panel) {
    return Pattern.compile("M([\\d.]+) ([\\d.]+) L\\1 ([\\d.]+)(?=[ \"](?!L))")
        .matcher(new Page("").row(360, panel, panel).svg())
        .results()
        .filter(
            line -> {
              double length = Double.parseDouble(line.group(2)) - Double.parseDouble(line.group(3));
              return length > 1 && length < 6;
            })
        .count();
  }

  @Test
  void mapsHaveEqualAxesAndTakePathsAboveTheirColours() {
    HeatPanel map =
        new HeatPanel("", EAST, NORTH, HEIGHT, slope(2, 4))
            .asMap()
            .add(Series.line("path", new double[] {0, 4}, new double[] {1, 1}));
    BufferedImage image = Bitmaps.of(map, 500, 500, 0);
    assertThat(Bitmaps.count(image, Palette.colour(0))).as("the path's pixels").isGreaterThan(200);
    int[] wide = {500, 0};
    int[] high = {500, 0};
    for (int y = 0; y < 500; y++) {
      for (int x = 0; x < 420; x++) {
        Color colour = new Color(image.getRGB(x, y));
        if (colour.equals(ColourScale.RISING.at(0)) || colour.equals(ColourScale.RISING.at(1))) {
          wide[0] = Math.min(wide[0], x);
          wide[1] = Math.max(wide[1], x);
          high[0] = Math.min(high[0], y);
          high[1] = Math.max(high[1], y);
        }
      }
    }
    // From the lowest cell's left and bottom to the highest one's right and top: 4 m by 2 m.
    double ratio = (wide[1] - wide[0]) / (double) (high[1] - high[0]);
    assertThat(ratio).isCloseTo(2, within(0.05));
  }

  @ParameterizedTest
  @EnumSource(ColourScale.class)
  void lightnessDistinguishesHighFromLowForEveryEye(ColourScale shades) {
    for (double[][] eye : Eyes.ALL) {
      double before = Double.NEGATIVE_INFINITY;
      for (int i = 0; i <= 20; i++) {
        boolean isFalling = shades == ColourScale.AROUND_ZERO && i > 10;
        double lightness = Eyes.lab(eye, shades.at(i / 20.0))[0] * (isFalling ? -1 : 1);
        boolean isTurn = shades == ColourScale.AROUND_ZERO && i == 11;
        if (!isTurn) {
          assertThat(lightness).as("step %d", i).isGreaterThan(before);
        }
        before = lightness;
      }
    }
  }

  @Test
  void bothSidesOfZeroDifferToEveryEye() {
    for (double[][] eye : Eyes.ALL) {
      for (double part : new double[] {0.1, 0.25, 0.4}) {
        Color one = ColourScale.AROUND_ZERO.at(part);
        Color other = ColourScale.AROUND_ZERO.at(1 - part);
        assertThat(Eyes.distance(eye, one, other)).isGreaterThan(15);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({
    "0, 1, 5, '0.0 0.2 0.4 0.6 0.8 1.0'",
    "-1, 1, 4, '-1.0 -0.5 0.0 0.5 1.0'",
    "0.03, 0.98, 4, '0.5'",
    "-180, 180, 10, '-150.0 -100.0 -50.0 0.0 50.0 100.0 150.0'",
    "0, 0.003, 3, '0.0 0.001 0.002 0.003'"
  })
  void ticksAreRoundNumbers(double low, double high, int most, String ticks) {
    StringBuilder found = new StringBuilder();
    for (double tick : new Range(low, high).ticks(most)) {
      found.append(found.isEmpty() ? "" : " ").append(tick == 0 ? 0.0 : tick);
    }
    assertThat(found.toString()).isEqualTo(ticks);
  }

  @Test
  void refusesWhatIsNoMatrixOverFixedAxes() {
    assertThatThrownBy(() -> new HeatPanel("h", HEIGHT, NORTH, HEIGHT, slope(2, 2)))
        .hasMessage("the axes height and north of a heat map want fixed ends");
    assertThatThrownBy(() -> new HeatPanel("h", EAST, NORTH, HEIGHT, new double[0][]))
        .hasMessage("the heat map h has no cells");
    assertThatThrownBy(() -> new HeatPanel("h", EAST, NORTH, HEIGHT, new double[][] {{1}, {1, 2}}))
        .hasMessage("rows of the heat map h have 2 and 1");
  }

  @Test
  void numbersThatMeanSomethingHaveAColourEachAndTheirMeaningBesideTheBar() {
    double[][] cells = {{0, 1, 2}};
    HeatPanel panel =
        new HeatPanel(
                "", Axis.of("x", "").between(0, 3), Axis.of("y", "").between(0, 1), HEIGHT, cells)
            .whereNumbersMean("never", "once", "more");
    assertThat(new Page("").row(300, panel).svg()).contains(">never<", ">once<", ">more<");
    BufferedImage image = Bitmaps.of(panel, 500, 300, 10);
    for (double part : new double[] {0.5 / 3, 1.5 / 3, 2.5 / 3}) {
      int level = (int) (part * 64);
      // a third of what is between the axes, and a third of the bar
      assertThat(Bitmaps.count(image, ColourScale.RISING.at(level / 63.0))).isGreaterThan(20_000L);
    }
    assertThat(Bitmaps.count(image, ColourScale.RISING.at(0))).isZero(); // none between
  }
}
