package org.dfra.behaviors.raster;

import org.dfra.geometry.LocalPosition;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Polygon;

/**
 * The planner's axes: y along the lanes, x across them to the right, origin at the region's centre.
 * These are east and north where the lanes run northward.
 */
final class LaneAxes {

  private final double sin;
  private final double cos;

  /**
   * @param bearing of the lanes, radians, clockwise from north
   */
  LaneAxes(double bearing) {
    this.sin = Math.sin(bearing);
    this.cos = Math.cos(bearing);
  }

  /** An outline, east and north, in these axes, and counter-clockwise. */
  Polygon of(Polygon outline) {
    Coordinate[] ring = outline.getExteriorRing().getCoordinates().clone();
    for (int i = 0; i < ring.length; i++) {
      double east = ring[i].x;
      double north = ring[i].y;
      ring[i] = new Coordinate(east * cos - north * sin, east * sin + north * cos);
    }
    Polygon turned = outline.getFactory().createPolygon(ring);
    boolean isCounterClockwise = Orientation.isCCW(turned.getCoordinates());
    return isCounterClockwise ? turned : turned.reverse();
  }

  /** A point in these axes, in the region's frame. */
  LocalPosition local(Coordinate point) {
    return new LocalPosition(point.x * cos + point.y * sin, point.y * cos - point.x * sin, 0);
  }
}
