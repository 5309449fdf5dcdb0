package org.dfra.behaviors.raster;

import org.locationtech.jts.algorithm.Distance;
import org.locationtech.jts.geom.Coordinate;

/**
 * A straight segment to be driven, in the planner's axes: x across the lanes, y along them, metres.
 *
 * @param from its start
 * @param to its end
 * @param strip index of its strip, from 0
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
