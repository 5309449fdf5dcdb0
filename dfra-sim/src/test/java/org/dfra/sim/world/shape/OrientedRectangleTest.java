package org.dfra.sim.world.shape;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

class OrientedRectangleTest {

  private static OrientedRectangle box(
      double length, double width, double east, double north, double yaw) {
    OrientedRectangle box = new OrientedRectangle(length, width);
    box.move(east, north, Math.cos(yaw), Math.sin(yaw));
    return box;
  }

  private static StaticObstacle disc(double east, double north, double radius) {
    return new StaticObstacle("disc", new Disc(east, north, radius), 1, 1);
  }

  @Test
  void touchesWhatReachesIntoIt() {
    OrientedRectangle box = box(2, 1, 0, 0, 0);
    assertThat(box.touches(disc(1.5, 0, 0.51))).isTrue();
    assertThat(box.touches(disc(1.5, 0, 0.49))).isFalse();
    assertThat(box.touches(disc(0, 0, 0.1))).as("within").isTrue();
    assertThat(box.touches(disc(1.3, 0.8, 0.42))).as("0.424 from the corner").isFalse();
    assertThat(box.touches(disc(1.3, 0.8, 0.43))).isTrue();
    assertThat(box.touches(box(2, 1, 1.99, 0, 0))).isTrue();
    assertThat(box.touches(box(2, 1, 2.01, 0, 0))).isFalse();
    assertThat(box.touches(box(2, 1, 1.6, 0, Math.PI / 2))).isFalse();
    assertThat(box.touches(box(0.1, 0.1, 0.2, 0.1, 0.3))).as("within").isTrue();
  }

  @Test
  void touchesPolygonsThatHoldItAndThatItHolds() {
    OrientedRectangle box = box(2, 1, 5, 5, 0.4);
    assertThat(box.touches(square(5, 5, 10))).as("within a large one").isTrue();
    assertThat(box.touches(square(5, 5, 0.1))).as("a small one within").isTrue();
    assertThat(box.touches(square(9, 5, 1))).isFalse();
    Vertex[] bay = {
      new Vertex(3, 3),
      new Vertex(7, 3),
      new Vertex(7, 7),
      new Vertex(6.9, 7),
      new Vertex(6.9, 3.1),
      new Vertex(3, 3.1)
    };
    assertThat(box.touches(new StaticObstacle("bay", new Polygon(List.of(bay)), 1, 1)))
        .as("in the bay of one that is not convex")
        .isFalse();
  }

  private static StaticObstacle square(double east, double north, double half) {
    return new StaticObstacle(
        "square",
        new Polygon(
            List.of(
                new Vertex(east - half, north - half),
                new Vertex(east + half, north - half),
                new Vertex(east + half, north + half),
                new Vertex(east - half, north + half))),
        1,
        1);
  }

  /**
   * Random boxes, discs and polygons against many points of each box, which lie less than 1 cm
   * apart: with a point of both they touch; where they touch there is such a point of a box that is
   * 4 cm larger.
   */
  @Test
  void agreesWithTryingPoints() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int round = 0; round < 200; round++) {
      agreesOnce(random, "-Ddfra.seed=" + seed + ", round " + round);
    }
  }

  private static void agreesOnce(Random random, String what) {
    OrientedRectangle box =
        box(0.5 + random.nextDouble(), 0.5 + random.nextDouble(), 0, 0, 7 * random.nextDouble());
    OrientedRectangle other =
        box(
            0.5 + random.nextDouble(),
            0.5 + random.nextDouble(),
            2 * random.nextDouble() - 1,
            2 * random.nextDouble() - 1,
            7 * random.nextDouble());
    StaticObstacle disc =
        disc(
            3 * random.nextDouble() - 1.5,
            3 * random.nextDouble() - 1.5,
            0.1 + random.nextDouble());
    double turn = 2 * random.nextDouble();
    double east = 3 * random.nextDouble() - 1.5;
    double north = 3 * random.nextDouble() - 1.5;
    Vertex[] corners = new Vertex[3];
    for (int i = 0; i < 3; i++) {
      double angle = turn + i * 2 + 0.5 * random.nextDouble();
      corners[i] = new Vertex(east + 0.8 * Math.cos(angle), north + 0.8 * Math.sin(angle));
    }
    StaticObstacle triangle = new StaticObstacle("triangle", new Polygon(List.of(corners)), 1, 1);

    agrees(what, box, disc, box.touches(disc));
    agrees(what, box, triangle, box.touches(triangle));
    StaticObstacle asSolid =
        new StaticObstacle(
            "box",
            new Polygon(
                List.of(
                    new Vertex(other.cornerEast(0), other.cornerNorth(0)),
                    new Vertex(other.cornerEast(1), other.cornerNorth(1)),
                    new Vertex(other.cornerEast(2), other.cornerNorth(2)),
                    new Vertex(other.cornerEast(3), other.cornerNorth(3)))),
            1,
            1);
    agrees(what, box, asSolid, box.touches(other));
    assertThat(other.touches(box)).as(what).isEqualTo(box.touches(other));
  }

  private static void agrees(
      String what, OrientedRectangle box, StaticObstacle solid, boolean touches) {
    if (meet(box, solid, 0)) {
      assertThat(touches).as("%s: %s has a common point", what, solid.name()).isTrue();
    } else if (touches) {
      assertThat(meet(box, solid, 0.04)).as("%s: %s touches", what, solid.name()).isTrue();
    }
  }

  /** Whether one of 200 × 200 points of the box, so much larger all around, lies in the solid. */
  private static boolean meet(OrientedRectangle box, StaticObstacle solid, double larger) {
    for (int i = 0; i <= 200; i++) {
      for (int j = 0; j <= 200; j++) {
        double x = (box.halfLength + larger) * (i / 100.0 - 1);
        double y = (box.halfWidth + larger) * (j / 100.0 - 1);
        if (solid
            .outline()
            .contains(
                box.east + box.cos * x - box.sin * y, box.north + box.sin * x + box.cos * y)) {
          return true;
        }
      }
    }
    return false;
  }
}
