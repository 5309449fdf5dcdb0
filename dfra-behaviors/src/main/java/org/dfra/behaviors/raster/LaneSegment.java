package org.dfra.behaviors.raster;

import org.locationtech.jts.algorithm.Distance;
import org.locationtech.jts.geom.Coordinate;

/**
 * A straight piece of way to be driven, in the planner's axes: x across the lanes, y along them,
 * metres.
 *
 * @param from where it begins
 * @param to where it ends
 * @param strip the number of the strip of ground that it lies in, the first is 0
 */
record LaneSegment(Coordinate from, Coordinate to, int strip) {

  LaneSegment reversed() {
    return new LaneSegment(to, from, strip);
  }

  double length() {
    return from.distance(to);
  }

  double distance(Coordinate point) {
    return Distance.pointToSegment(point, from, to);
  }
}
