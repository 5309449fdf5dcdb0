package org.dfra.behaviors.perceptual.mines;

/**
 * Pose of a robot on the map.
 *
 * @param east metres
 * @param north metres
 * @param yaw radians, 0 is east, counter-clockwise is +
 */
public record Viewpoint(double east, double north, double yaw) {

  /** From the robot's base, x forward, y left, to the map, x east, y north. */
  public GroundPoint toMap(GroundPoint spot) {
    double cos = Math.cos(yaw);
    double sin = Math.sin(yaw);
    return new GroundPoint(
        east + cos * spot.x() - sin * spot.y(), north + sin * spot.x() + cos * spot.y());
  }

  /** From the map to the robot's base. */
  public GroundPoint toBase(GroundPoint spot) {
    double cos = Math.cos(yaw);
    double sin = Math.sin(yaw);
    double dx = spot.x() - east;
    double dy = spot.y() - north;
    return new GroundPoint(cos * dx + sin * dy, cos * dy - sin * dx);
  }

  /** Distance to another, metres, regardless of yaw. */
  public double distance(Viewpoint other) {
    return Math.hypot(east - other.east, north - other.north);
  }

  /** Yaw difference to another, radians, 0 to π. */
  public double yawDifference(Viewpoint other) {
    return Math.abs(Math.IEEEremainder(yaw - other.yaw, 2 * Math.PI));
  }
}
