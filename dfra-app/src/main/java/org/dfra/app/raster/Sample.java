package org.dfra.app.raster;

/**
 * One moment of one robot's search, in the region's frame: east, north, metres.
 *
 * @param time seconds since the search began
 * @param east where it truly is
 * @param north where it truly is
 * @param yaw where it truly heads, radians
 * @param speed over ground, truly, metres per second
 * @param estimatedEast where it believes it is; NaN while it does not know
 * @param estimatedNorth likewise
 * @param estimatedYaw likewise, radians
 * @param fixEast its last position by a receiver; NaN before the first
 * @param fixNorth likewise
 * @param done share of its waypoints that are done, 0 to 1
 * @param clearance from its body to the nearest obstacle or robot, metres; 0 is touching
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

  /** Whether it knows where it is. */
  public boolean isEstimated() {
    return !Double.isNaN(estimatedEast);
  }
}
