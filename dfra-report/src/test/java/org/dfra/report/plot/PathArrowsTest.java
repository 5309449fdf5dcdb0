package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import org.dfra.report.plot.PathArrows.Arrow;
import org.junit.jupiter.api.Test;

class PathArrowsTest {

  private static List<Point2D> line(double dx, double dy, int points) {
    List<Point2D> all = new ArrayList<>();
    for (int i = 0; i < points; i++) {
      all.add(new Point2D.Double(i * dx, i * dy));
    }
    return all;
  }

  @Test
  void arrowsLookWhereThePathGoesAndAreSpreadAlongIt() {
    List<Arrow> arrows = PathArrows.arrows(line(0, -4, 200)); // up, 796 pixels
    assertThat(arrows).hasSize(7);
    assertThat(arrows).allSatisfy(a -> assertThat(a.angle()).isCloseTo(-Math.PI / 2, within(1e-9)));
    for (int i = 1; i < arrows.size(); i++) {
      assertThat(arrows.get(i).at().distance(arrows.get(i - 1).at())).isBetween(100.0, 130.0);
    }
  }

  @Test
  void aShortPathHasOneAndARobotThatStoodHasNone() {
    assertThat(PathArrows.arrows(line(5, 0, 12))).hasSize(1);
    assertThat(PathArrows.arrows(line(0.01, 0, 200))).isEmpty();
    assertThat(PathArrows.arrows(line(0, 0, 1))).isEmpty();
  }
}
