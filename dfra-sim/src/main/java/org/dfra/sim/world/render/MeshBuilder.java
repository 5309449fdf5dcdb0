package org.dfra.sim.world.render;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.render.MeshFace.Paint;
import org.dfra.sim.world.shape.PlanarShape;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/** Creates the facets of upright prisms, boxes and wheels. */
final class MeshBuilder {

  private MeshBuilder() {}

  /** A prism over an outline; a disc is approximated by the given number of sides. */
  static List<MeshFace> prism(
      PlanarShape outline, int sides, double bottom, double top, Paint paint) {
    List<MeshFace> facets = new ArrayList<>();
    List<Vertex> corners = corners(outline, sides);
    for (int i = 0; i < corners.size(); i++) {
      Vertex a = corners.get(i);
      Vertex b = corners.get((i + 1) % corners.size());
      facets.add(
          MeshFace.of(
              new double[] {
                a.east(), a.north(), bottom, b.east(), b.north(), bottom, b.east(), b.north(), top,
                a.east(), a.north(), top
              },
              paint));
    }
    if (outline instanceof Polygon) {
      for (List<Vertex> triangle : Triangles.of(corners)) {
        facets.add(level(triangle, top, paint));
      }
    } else {
      facets.add(level(corners, top, paint));
    }
    return facets;
  }

  private static List<Vertex> corners(PlanarShape outline, int sides) {
    if (outline instanceof Polygon polygon) {
      return polygon.corners();
    }
    Disc disc = outline.bounds();
    List<Vertex> corners = new ArrayList<>();
    for (int i = 0; i < sides; i++) {
      double angle = 2 * Math.PI * i / sides;
      corners.add(
          new Vertex(
              disc.east() + disc.radius() * StrictMath.cos(angle),
              disc.north() + disc.radius() * StrictMath.sin(angle)));
    }
    return corners;
  }

  private static MeshFace level(List<Vertex> corners, double up, Paint paint) {
    double[] at = new double[3 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      at[3 * i] = corners.get(i).east();
      at[3 * i + 1] = corners.get(i).north();
      at[3 * i + 2] = up;
    }
    return new MeshFace(at, 0, 0, 1, paint);
  }

  /** A box between two corners, all six sides. */
  static List<MeshFace> box(
      double x0, double y0, double z0, double x1, double y1, double z1, Paint paint) {
    return List.of(
        MeshFace.of(new double[] {x1, y0, z0, x1, y1, z0, x1, y1, z1, x1, y0, z1}, paint),
        MeshFace.of(new double[] {x0, y1, z0, x0, y0, z0, x0, y0, z1, x0, y1, z1}, paint),
        MeshFace.of(new double[] {x1, y1, z0, x0, y1, z0, x0, y1, z1, x1, y1, z1}, paint),
        MeshFace.of(new double[] {x0, y0, z0, x1, y0, z0, x1, y0, z1, x0, y0, z1}, paint),
        MeshFace.of(new double[] {x0, y0, z1, x1, y0, z1, x1, y1, z1, x0, y1, z1}, paint),
        MeshFace.of(new double[] {x0, y1, z0, x1, y1, z0, x1, y0, z0, x0, y0, z0}, paint));
  }

  /** A wheel whose axle lies along y. */
  static List<MeshFace> wheel(double x, double y, double radius, double width, Paint paint) {
    int sides = 14;
    List<MeshFace> facets = new ArrayList<>();
    double[] left = new double[3 * sides];
    double[] right = new double[3 * sides];
    for (int i = 0; i < sides; i++) {
      double angle = 2 * Math.PI * i / sides;
      double next = 2 * Math.PI * (i + 1) / sides;
      double ax = x + radius * StrictMath.cos(angle);
      double az = radius + radius * StrictMath.sin(angle);
      double bx = x + radius * StrictMath.cos(next);
      double bz = radius + radius * StrictMath.sin(next);
      double y0 = y - width / 2;
      double y1 = y + width / 2;
      facets.add(MeshFace.of(new double[] {ax, y0, az, ax, y1, az, bx, y1, bz, bx, y0, bz}, paint));
      put(right, i, ax, y0, az);
      put(left, sides - 1 - i, ax, y1, az);
    }
    facets.add(MeshFace.of(left, paint));
    facets.add(MeshFace.of(right, paint));
    return facets;
  }

  private static void put(double[] corners, int i, double x, double y, double z) {
    corners[3 * i] = x;
    corners[3 * i + 1] = y;
    corners[3 * i + 2] = z;
  }

  /** Triangulates a polygon by ear clipping. */
  static final class Triangles {

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
}
