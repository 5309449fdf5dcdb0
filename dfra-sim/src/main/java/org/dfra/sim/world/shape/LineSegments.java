package org.dfra.sim.world.shape;

import org.dfra.sim.world.shape.PlanarShape.Vertex;

/** Geometric predicates of line segments. */
final class LineSegments {

  private LineSegments() {}

  /** Twice the area of the triangle a, b, p: above 0 where p is to the left of a to b. */
  static double side(double ax, double ay, double bx, double by, double px, double py) {
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
  }

  private static double side(Vertex a, Vertex b, Vertex p) {
    return side(a.east(), a.north(), b.east(), b.north(), p.east(), p.north());
  }

  /** Whether the segment from a to b contains the point. */
  static boolean contains(Vertex a, Vertex b, double east, double north) {
    return side(a.east(), a.north(), b.east(), b.north(), east, north) == 0
        && Math.min(a.east(), b.east()) <= east
        && east <= Math.max(a.east(), b.east())
        && Math.min(a.north(), b.north()) <= north
        && north <= Math.max(a.north(), b.north());
  }

  /** Whether the segments from a to b and from c to d intersect. */
  static boolean intersect(Vertex a, Vertex b, Vertex c, Vertex d) {
    double abc = side(a, b, c);
    double abd = side(a, b, d);
    double cda = side(c, d, a);
    double cdb = side(c, d, b);
    if (abc != 0 && abd != 0 && cda != 0 && cdb != 0) {
      return abc > 0 != abd > 0 && cda > 0 != cdb > 0;
    }
    return contains(a, b, c.east(), c.north())
        || contains(a, b, d.east(), d.north())
        || contains(c, d, a.east(), a.north())
        || contains(c, d, b.east(), b.north());
  }

  /**
   * Whether the edges i (a to b) and j (c to d), j after i, of a polygon of n corners intersect
   * improperly: neighbours share one corner only, others none.
   */
  static boolean neighboursCross(int i, int j, int n, Vertex a, Vertex b, Vertex c, Vertex d) {
    if (j == i + 1) {
      return contains(a, b, d.east(), d.north()) || contains(c, d, a.east(), a.north());
    }
    if (i == 0 && j == n - 1) {
      return contains(a, b, c.east(), c.north()) || contains(c, d, b.east(), b.north());
    }
    return intersect(a, b, c, d);
  }
}
