package org.dfra.drivers.pantilt.ptu;

import java.util.Locale;

/**
 * What one axis can do, in the unit's own numbers, and how these are converted.
 *
 * @param axis which one
 * @param resolution seconds of arc from one position to the next
 * @param least position farthest to the right, or down; below {@code most}
 * @param most position farthest to the left, or up
 * @param slowest positions per second
 * @param fastest positions per second, not below {@code slowest}
 */
public record PtuAxisLimits(
    PtuAxis axis, double resolution, int least, int most, int slowest, int fastest) {

  private static final double SECONDS_OF_ARC = Math.toRadians(1.0 / 3600);
  private static final double COARSEST = 3600; // a degree: no such unit was made

  public PtuAxisLimits {
    if (!(resolution > 0 && resolution <= COARSEST)) {
      throw new IllegalArgumentException(
          "a resolution of " + resolution + " seconds of arc for " + axis);
    }
    if (least >= most) {
      throw new IllegalArgumentException(axis + " from position " + least + " to " + most);
    }
    if (slowest < 0 || fastest < 1 || slowest > fastest) {
      throw new IllegalArgumentException(
          axis + " speeds from " + slowest + " to " + fastest + " positions per second");
    }
  }

  /** The angle of a position, radians; to the left or up is +. */
  public double radians(double position) {
    return position * resolution * SECONDS_OF_ARC;
  }

  /** Least angle, radians. */
  public double leastAngle() {
    return radians(least);
  }

  /** Greatest angle, radians. */
  public double mostAngle() {
    return radians(most);
  }

  /** Greatest speed, radians per second. */
  public double fastestSpeed() {
    return radians(fastest);
  }

  /**
   * The position nearest to an angle.
   *
   * @param angle radians
   * @throws IllegalArgumentException if the axis cannot go there; names both sides and what it can
   */
  public int position(double angle) {
    double position = angle / (resolution * SECONDS_OF_ARC);
    // Half a position more is the limit, rounded by whoever asked for it.
    if (position > most + 0.5 || position < least - 0.5) {
      boolean over = position > most;
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s of %.4f rad is %s the limit of %.4f rad; ask for %.4f to %.4f rad",
              axis,
              angle,
              over ? "above" : "below",
              over ? mostAngle() : leastAngle(),
              leastAngle(),
              mostAngle()));
    }
    return (int) Math.max(least, Math.min(most, Math.rint(position)));
  }

  /** The speed nearest to so many radians per second that the axis can, positions per second. */
  public int speed(double radiansPerSecond) {
    double wanted = radiansPerSecond / (resolution * SECONDS_OF_ARC);
    return (int) Math.max(Math.max(1, slowest), Math.min(fastest, Math.rint(wanted)));
  }
}
