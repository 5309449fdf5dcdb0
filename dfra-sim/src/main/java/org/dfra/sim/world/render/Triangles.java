package org.dfra.sim.world.render;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.shape.Vertex;

/** Triangulates a polygon by ear clipping. */
final class Triangles {

  private Triangles() {}

  /**
   * @param corners counter-clockwise, of a polygon that does not cross itself
   */
  static List<List<Vertex>> of(List<Vertex> corners) {
    List<Vertex> left = new ArrayList<>(corners);
    List<List<Vertex>> triangles = new ArrayList<>();
    while (left.size() > 3) {
      int ear = ear(left);
      int n = left.size();
      triangles.add(List.of(left.get((ear + n - 1) % n), left.get(ear), left.get((ear + 1) % n)));
      left.remove(ear);
    }
    triangles.add(List.copyOf(left));
    return triangles;
  }

  /** An ear that can be clipped; the first corner if rounding leaves none. */
  private static int ear(List<Vertex> corners) {
    int n = corners.size();
    for (int i = 0; i < n; i++) {
      Vertex a = corners.get((i + n - 1) % n);
      Vertex b = corners.get(i);
      Vertex c = corners.get((i + 1) % n);
      if (side(a, b, c) > 0
          && corners.stream()
              .filter(p -> p != a && p != b && p != c)
              .noneMatch(p -> side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0)) {
        return i;
      }
    }
    return 0;
  }

  private static double side(Vertex a, Vertex b, Vertex p) {
    return (b.east() - a.east()) * (p.north() - a.north())
        - (b.north() - a.north()) * (p.east() - a.east());
  }
}
