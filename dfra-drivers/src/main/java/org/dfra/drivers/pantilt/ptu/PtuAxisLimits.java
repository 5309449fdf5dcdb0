package org.dfra.drivers.pantilt.ptu;

import java.util.Locale;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;

/**
 * The limits of an axis in the unit's own numbers, and their conversion.
 *
 * @param axis the axis
 * @param resolution seconds of arc from one position to the next
 * @param minPosition position farthest to the right, or down; below {@code maxPosition}
 * @param maxPosition position farthest to the left, or up
 * @param minSpeed positions per second
 * @param maxSpeed positions per second, not below {@code minSpeed}
 */
record PtuAxisLimits(
    PtuAxis axis, double resolution, int minPosition, int maxPosition, int minSpeed, int maxSpeed) {

  private static final double SECONDS_OF_ARC = Math.toRadians(1.0 / 3600);
  private static final double COARSEST = 3600; // a degree: no unit has this resolution

  public PtuAxisLimits {
    if (!(resolution > 0 && resolution <= COARSEST)) {
      throw new IllegalArgumentException(
          "a resolution of " + resolution + " seconds of arc for " + axis);
    }
    if (minPosition >= maxPosition) {
      throw new IllegalArgumentException(
          axis + " from position " + minPosition + " to " + maxPosition);
    }
    if (minSpeed < 0 || maxSpeed < 1 || minSpeed > maxSpeed) {
      throw new IllegalArgumentException(
          axis + " speeds from " + minSpeed + " to " + maxSpeed + " positions per second");
    }
  }

  /** The angle of a position, radians; to the left or up is +. */
  public double radians(double position) {
    return position * resolution * SECONDS_OF_ARC;
  }

  /** Minimum angle, radians. */
  public double minAngle() {
    return radians(minPosition);
  }

  /** Maximum angle, radians. */
  public double maxAngle() {
    return radians(maxPosition);
  }

  /** Maximum speed, radians per second. */
  public double fastestSpeed() {
    return radians(maxSpeed);
  }

  /**
   * The position nearest to an angle.
   *
   * @param angle radians
   * @throws IllegalArgumentException if the angle is outside the limits; the message states the
   *     angle and the limits
   */
  public int position(double angle) {
    double position = angle / (resolution * SECONDS_OF_ARC);
    // Half a position more is the limit itself, rounded by the caller.
    if (position > maxPosition + 0.5 || position < minPosition - 0.5) {
      boolean over = position > maxPosition;
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s of %.4f rad is %s the limit of %.4f rad; ask for %.4f to %.4f rad",
              axis,
              angle,
              over ? "above" : "below",
              over ? maxAngle() : minAngle(),
              minAngle(),
              maxAngle()));
    }
    return (int) Math.max(minPosition, Math.min(maxPosition, Math.rint(position)));
  }

  /** The possible speed nearest to a number of radians per second, positions per second. */
  public int speed(double radiansPerSecond) {
    double requested = radiansPerSecond / (resolution * SECONDS_OF_ARC);
    return (int) Math.max(Math.max(1, minSpeed), Math.min(maxSpeed, Math.rint(requested)));
  }
}
