package org.dfra.sim.world.shape;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** The outline of an object, seen from above. */
public sealed interface PlanarShape permits PlanarShape.Disc, PlanarShape.Polygon {

  /** Whether a point lies in it or on its edge. */
  boolean contains(double east, double north);

  /** A bounding disc. */
  Disc bounds();

  /**
   * A corner of a polygon.
   *
   * @param east metres
   * @param north metres
   */
  record Vertex(double east, double north) {

    public Vertex {
      if (!Double.isFinite(east) || !Double.isFinite(north)) {
        throw new IllegalArgumentException("the corner " + east + "," + north + " is not finite");
      }
    }
  }

  /**
   * A disc, such as a post seen from above.
   *
   * @param east of its centre, metres
   * @param north of its centre, metres
   * @param radius metres, above 0
   */
  record Disc(double east, double north, double radius) implements PlanarShape {

    public Disc {
      if (!Double.isFinite(east) || !Double.isFinite(north)) {
        throw new IllegalArgumentException("the centre " + east + "," + north + " is not finite");
      }
      if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException("the radius " + radius + " m is not above 0");
      }
    }

    @Override
    public boolean contains(double east, double north) {
      double x = east - this.east;
      double y = north - this.north;
      return x * x + y * y <= radius * radius;
    }

    @Override
    public Disc bounds() {
      return this;
    }
  }

  /**
   * A simple polygon.
   *
   * @param corners at least three, counter-clockwise, the first not repeated at the end
   */
  record Polygon(List<Vertex> corners) implements PlanarShape {

    private static final double LEAST_AREA = 1e-6; // square metres

    /** Orders the corners counter-clockwise and drops a last one that repeats the first. */
    public Polygon {
      List<Vertex> given = new ArrayList<>(corners);
      if (given.size() > 1 && given.get(0).equals(given.get(given.size() - 1))) {
        given.remove(given.size() - 1);
      }
      String complaint = complaint(given);
      if (complaint != null) {
        throw new IllegalArgumentException(complaint);
      }
      if (area(given) < 0) {
        Collections.reverse(given);
      }
      corners = List.copyOf(given);
    }

    /** Square metres. */
    public double area() {
      return area(corners);
    }

    @Override
    public boolean contains(double east, double north) {
      boolean inside = false;
      for (int i = 0; i < corners.size(); i++) {
        Vertex a = corners.get(i);
        Vertex b = corners.get((i + 1) % corners.size());
        if (LineSegments.contains(a, b, east, north)) {
          return true;
        }
        if (a.north() > north != b.north() > north
            && east
                < (b.east() - a.east()) * (north - a.north()) / (b.north() - a.north())
                    + a.east()) {
          inside = !inside;
        }
      }
      return inside;
    }

    @Override
    public Disc bounds() {
      double west = corners.stream().mapToDouble(Vertex::east).min().orElseThrow();
      double east = corners.stream().mapToDouble(Vertex::east).max().orElseThrow();
      double south = corners.stream().mapToDouble(Vertex::north).min().orElseThrow();
      double north = corners.stream().mapToDouble(Vertex::north).max().orElseThrow();
      double x = (west + east) / 2;
      double y = (south + north) / 2;
      double farthest =
          corners.stream()
              .mapToDouble(c -> (c.east() - x) * (c.east() - x) + (c.north() - y) * (c.north() - y))
              .max()
              .orElseThrow();
      return new Disc(x, y, Math.sqrt(farthest) * (1 + 1e-12));
    }

    /** The reason why these corners are no simple polygon; null if they are one. */
    private static @Nullable String complaint(List<Vertex> corners) {
      int n = corners.size();
      if (n < 3) {
        return "a polygon of " + n + " corners encloses nothing; give three or more";
      }
      for (int i = 0; i < n; i++) {
        if (corners.get(i).equals(corners.get((i + 1) % n))) {
          return "the corner " + text(corners.get(i)) + " is given twice in a row; delete one";
        }
      }
      for (int i = 0; i < n; i++) {
        for (int j = i + 1; j < n; j++) {
          Vertex a = corners.get(i);
          Vertex b = corners.get(i + 1);
          Vertex c = corners.get(j);
          Vertex d = corners.get((j + 1) % n);
          if (LineSegments.neighboursCross(i, j, n, a, b, c, d)) {
            return "the polygon crosses itself: the edge from "
                + text(a)
                + " to "
                + text(b)
                + " meets the one from "
                + text(c)
                + " to "
                + text(d)
                + "; give the corners in their order around it";
          }
        }
      }
      return Math.abs(area(corners)) < LEAST_AREA
          ? "the polygon encloses no area; give corners that do not lie on one line"
          : null;
    }

    private static String text(Vertex corner) {
      return corner.east() + "," + corner.north();
    }

    /** Square metres; negative for clockwise corners. */
    private static double area(List<Vertex> corners) {
      double twice = 0;
      Vertex origin = corners.get(0);
      for (int i = 1; i + 1 < corners.size(); i++) {
        Vertex a = corners.get(i);
        Vertex b = corners.get(i + 1);
        twice +=
            (a.east() - origin.east()) * (b.north() - origin.north())
                - (a.north() - origin.north()) * (b.east() - origin.east());
      }
      return twice / 2;
    }
  }
}
