package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dfra.report.plot.MatrixPanel.Cell;
import org.dfra.report.plot.MatrixPanel.Factor;
import org.junit.jupiter.api.Test;

/** Panels of words. */
class TablesTest {

  private static final Factor SIDE = new Factor("side", List.of("close", "away"));
  private static final Factor AHEAD = new Factor("ahead", List.of("close", "medium", "away"));

  private static String words(Panel panel, int height) {
    return new Page("")
        .row(height, panel)
        .svg()
        .lines()
        .filter(line -> line.startsWith("      >") || line.contains("</text"))
        .collect(Collectors.joining(" "));
  }

  @Test
  void longLinesGoOnInTheNextOneAndNoWordIsLost() {
    List<String> lines =
        IntStream.range(0, 9)
            .mapToObj(
                i -> "if number" + i + " is close and the other one is far away then slow down")
            .toList();
    TextPanel panel = new TextPanel("Rules", lines, 3);
    int high = panel.height(500);
    assertThat(high).isGreaterThan(panel.height(1180));
    BufferedImage image = Bitmaps.of(panel, 500, high, 10);
    assertThat(Bitmaps.inkAtEdge(image, 12)).isEmpty();
    String words = new Page("").row(panel.height(1188), panel).svg();
    for (int i = 0; i < 9; i++) {
      assertThat(words).contains("number" + i);
    }
    assertThat(words).doesNotContain("…");
  }

  @Test
  void aTextWithoutLinesIsItsTitle() {
    TextPanel panel = new TextPanel("Rules", List.of(), 2);
    assertThat(words(panel, panel.height(1188))).contains("Rules");
  }

  private static MatrixPanel matrix(Cell... cells) {
    return new MatrixPanel(
        "What to do",
        List.of(SIDE),
        List.of(AHEAD),
        List.of(List.of(cells[0], cells[1], cells[2]), List.of(cells[3], cells[4], cells[5])));
  }

  @Test
  void cellsStandUnderTheirHeadingsInTheirColours() {
    Cell stop = new Cell("stop", 0, false);
    Cell fast = new Cell("fast", 1, false);
    MatrixPanel panel = matrix(stop, stop, stop, stop, Cell.EMPTY, fast);
    BufferedImage image = Bitmaps.of(panel, 600, panel.height(), 10);
    assertThat(Bitmaps.inkAtEdge(image, 12)).isEmpty();
    int right = image.getWidth() - 30;
    int bottom = image.getHeight() - 32;
    assertThat(new Color(image.getRGB(right, bottom))).isEqualTo(ColourScale.RISING.tint(1));
    assertThat(new Color(image.getRGB(right, bottom - 22))).isEqualTo(ColourScale.RISING.tint(0));
    assertThat(words(panel, panel.height())).contains("side", "ahead", "medium", "stop", "fast");
  }

  @Test
  void theLastFactorChangesFastest() {
    assertThat(MatrixPanel.combinationsOf(List.of(SIDE, AHEAD)))
        .extracting(places -> places[0] + "" + places[1])
        .containsExactly("00", "01", "02", "10", "11", "12");
  }

  @Test
  void textCanBeReadOnEveryTint() {
    for (double[][] eye : Eyes.ALL) {
      for (ColourScale shades : ColourScale.values()) {
        for (int i = 0; i <= 10; i++) {
          double paper = Eyes.lab(eye, shades.tint(i / 10.0))[0];
          double ink = Eyes.lab(eye, Palette.INK)[0];
          assertThat(paper - ink).as("lightness of %s at %d", shades, i).isGreaterThan(45);
        }
      }
    }
  }

  @Test
  void refusesCellsThatDoNotFitTheFactors() {
    assertThatThrownBy(
            () -> new MatrixPanel("m", List.of(SIDE), List.of(AHEAD), List.of(List.of(Cell.EMPTY))))
        .hasMessage("the matrix m needs 2 rows of 3 cells");
  }
}
