package org.dfra.report.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Numbered bubbles stand beside their points, never on one another, as long as there is room. */
class NumberTagsTest {

  private static final double DIAMETER = 18;

  private static void haveRoom(List<Point2D> discs, Rectangle2D area) {
    for (int i = 0; i < discs.size(); i++) {
      assertThat(area.contains(discs.get(i))).as("%d is inside", i).isTrue();
      for (int j = 0; j < i; j++) {
        assertThat(discs.get(i).distance(discs.get(j)))
            .as("from %d to %d", j, i)
            .isGreaterThan(DIAMETER);
      }
    }
  }

  @Test
  void manyAtOnePlaceDoNotOverlap() {
    Rectangle2D area = new Rectangle2D.Double(0, 0, 500, 300);
    NumberTags tags = new NumberTags(area);
    for (int i = 0; i < 120; i++) {
      tags.add(30 + i % 3, 40 + i % 2, Integer.toString(i + 1));
    }
    List<Point2D> discs = tags.discs();
    assertThat(discs).hasSize(120);
    haveRoom(discs, area);
  }

  @Test
  void pointsInCornersHaveTheirsInside() {
    Rectangle2D area = new Rectangle2D.Double(10, 10, 200, 100);
    NumberTags tags = new NumberTags(area);
    for (int i = 0; i < 12; i++) {
      tags.add(i % 2 == 0 ? 10 : 210, i % 4 < 2 ? 10 : 110, Integer.toString(i));
    }
    haveRoom(tags.discs(), area);
  }
}
