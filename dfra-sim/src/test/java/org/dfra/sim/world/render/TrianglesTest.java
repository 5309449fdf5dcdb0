package org.dfra.sim.world.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.sim.world.render.MeshBuilder.Triangles;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

class TrianglesTest {

  /** Triangles that go round the same way and have the polygon's area together cover it once. */
  @Test
  void coverThePolygonOnce() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int round = 0; round < 100; round++) {
      coverOnce(random, "-Ddfra.seed=" + seed + ", round " + round);
    }
  }

  private static void coverOnce(Random random, String what) {
    int corners = 3 + random.nextInt(20);
    List<Vertex> star = new ArrayList<>();
    for (int i = 0; i < corners; i++) {
      double angle = 2 * Math.PI * i / corners;
      double radius = 0.3 + 3 * random.nextDouble();
      star.add(new Vertex(radius * Math.cos(angle), radius * Math.sin(angle)));
    }
    Polygon polygon = new Polygon(star);
    double area = 0;
    List<List<Vertex>> triangles = Triangles.of(polygon.corners());
    for (List<Vertex> t : triangles) {
      double twice =
          (t.get(1).east() - t.get(0).east()) * (t.get(2).north() - t.get(0).north())
              - (t.get(1).north() - t.get(0).north()) * (t.get(2).east() - t.get(0).east());
      assertThat(twice).as(what).isPositive();
      area += twice / 2;
    }
    assertThat(triangles).as(what).hasSize(corners - 2);
    assertThat(area).as(what).isCloseTo(polygon.area(), within(1e-9));
  }
}
