package org.dfra.behaviors.raster;

import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;

/**
 * Visibility tests inside a polygon. The polygon is enlarged by 0.1 µm, so that its own points lie
 * strictly inside: then a line between two of them lies inside unless it crosses an edge,
 * regardless of rounding.
 */
final class LineOfSight {

  private static final double SLACK = 1e-7; // metres
  private static final double MITRE_LIMIT = 5;

  private final double[] x; // of the edges' ends, in pairs
  private final double[] y;

  LineOfSight(Polygon polygon) {
    BufferParameters mitred =
        new BufferParameters(
            8, BufferParameters.CAP_SQUARE, BufferParameters.JOIN_MITRE, MITRE_LIMIT);
    Geometry rings = BufferOp.bufferOp(polygon, SLACK, mitred).getBoundary();
    int edges = rings.getNumPoints() - rings.getNumGeometries();
    x = new double[2 * edges];
    y = new double[2 * edges];
    int next = 0;
    for (int i = 0; i < rings.getNumGeometries(); i++) {
      Coordinate[] ring = rings.getGeometryN(i).getCoordinates();
      for (int j = 1; j < ring.length; j++) {
        x[next] = ring[j - 1].x;
        y[next++] = ring[j - 1].y;
        x[next] = ring[j].x;
        y[next++] = ring[j].y;
      }
    }
  }

  /** Whether the straight line between two points of the polygon lies inside. */
  boolean isClear(Coordinate a, Coordinate b) {
    double dx = b.x - a.x;
    double dy = b.y - a.y;
    double west = Math.min(a.x, b.x);
    double east = Math.max(a.x, b.x);
    double south = Math.min(a.y, b.y);
    double north = Math.max(a.y, b.y);
    for (int i = 0; i < x.length; i += 2) {
      double px = x[i];
      double py = y[i];
      double qx = x[i + 1];
      double qy = y[i + 1];
      boolean isAside =
          px < west && qx < west
              || px > east && qx > east
              || py < south && qy < south
              || py > north && qy > north;
      if (isAside) {
        continue;
      }
      double p = dx * (py - a.y) - dy * (px - a.x);
      double q = dx * (qy - a.y) - dy * (qx - a.x);
      double from = (qx - px) * (a.y - py) - (qy - py) * (a.x - px);
      double to = (qx - px) * (b.y - py) - (qy - py) * (b.x - px);
      if (p > 0 != q > 0 && from > 0 != to > 0) {
        return false;
      }
    }
    return true;
  }
}
