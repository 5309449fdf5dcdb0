package org.dfra.sim.world.shape;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;

/**
 * One beam followed through a world, slowly and plainly: the reference for {@link RayCaster}. All
 * crossings into outlines are found in the world's frame, by solving for both parameters with
 * Cramer's rule; the nearest at the right height counts.
 */
final class BeamByBeam {

  private final MutableTransform from;
  private final double dx;
  private final double dy;
  private final double dz;
  private double nearest;
  private boolean met;

  BeamByBeam(MutableTransform from, double c, double s, double longest) {
    this.from = from;
    this.dx = from.xx * c + from.xy * s;
    this.dy = from.yx * c + from.yy * s;
    this.dz = from.zx * c + from.zy * s;
    this.nearest = longest;
    if (dz < -1e-15) {
      at(-from.up / dz, -1, 1);
    }
  }

  double distance() {
    return met ? nearest : Double.POSITIVE_INFINITY;
  }

  void meet(StaticObstacle solid) {
    if (solid.outline() instanceof Disc disc) {
      double ox = from.east - disc.east();
      double oy = from.north - disc.north();
      double a = dx * dx + dy * dy;
      double p = 2 * (ox * dx + oy * dy) / a;
      double q = (ox * ox + oy * oy - disc.radius() * disc.radius()) / a;
      if (p * p / 4 >= q) {
        at(-p / 2 - Math.sqrt(p * p / 4 - q), 0, solid.height());
      }
    } else if (solid.outline() instanceof Polygon polygon) {
      edges(polygon.corners(), solid.height());
    }
  }

  void meetBox(OrientedRectangle box, double height) {
    List<Vertex> corners = new ArrayList<>();
    for (int[] sign : new int[][] {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      double x = sign[0] * box.halfLength;
      double y = sign[1] * box.halfWidth;
      corners.add(
          new Vertex(box.east + box.cos * x - box.sin * y, box.north + box.sin * x + box.cos * y));
    }
    edges(corners, height);
  }

  private void edges(List<Vertex> corners, double height) {
    for (int i = 0; i < corners.size(); i++) {
      Vertex a = corners.get(i);
      Vertex b = corners.get((i + 1) % corners.size());
      // from + t·d = a + w·(b − a)
      double ex = b.east() - a.east();
      double ey = b.north() - a.north();
      double determinant = dx * -ey + dy * ex;
      double rx = a.east() - from.east;
      double ry = a.north() - from.north;
      double t = (rx * -ey + ry * ex) / determinant;
      double w = (dx * ry - dy * rx) / determinant;
      boolean goesIn = ex * dy - ey * dx > 0; // to the left of the edge
      if (goesIn && w >= 0 && w <= 1) {
        at(t, 0, height);
      }
    }
  }

  private void at(double t, double bottom, double top) {
    double up = from.up + t * dz;
    if (t > 0 && t < nearest && up >= bottom && up <= top) {
      nearest = t;
      met = true;
    }
  }
}
