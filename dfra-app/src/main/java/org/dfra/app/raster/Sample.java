package org.dfra.app.raster;

/**
 * One sample of one robot's search, in the region's frame: east, north, metres.
 *
 * @param time seconds since the search began
 * @param east true position
 * @param north true position
 * @param yaw true heading, radians
 * @param speed true speed over ground, metres per second
 * @param estimatedEast estimated position; NaN while unknown
 * @param estimatedNorth likewise
 * @param estimatedYaw likewise, radians
 * @param fixEast its last position by a receiver; NaN before the first
 * @param fixNorth likewise
 * @param done share of its waypoints that are done, 0 to 1
 * @param clearance from its body to the nearest obstacle or robot, metres; 0 is contact
 */
public record Sample(
    double time,
    double east,
    double north,
    double yaw,
    double speed,
    double estimatedEast,
    double estimatedNorth,
    double estimatedYaw,
    double fixEast,
    double fixNorth,
    double done,
    double clearance) {

  /** Whether it has a position estimate. */
  public boolean isEstimated() {
    return !Double.isNaN(estimatedEast);
  }
}
