package org.dfra.flow.perceptual;

import java.time.Instant;

/**
 * The clearance around the front of a robot, from its body to the nearest obstacle.
 *
 * @param measured time of the newest scan it is based on, UTC
 * @param frame name of the robot's base, e.g. {@code atrv1/base_link}
 * @param left metres to the left of the body, not negative; the sensor's maximum range if nothing
 *     is there
 * @param centre metres ahead of the bumper, likewise
 * @param right metres to the right of the body, likewise
 */
public record Clearance(Instant measured, String frame, double left, double centre, double right)
    implements Percept {

  public Clearance {
    if (!(left >= 0 && centre >= 0 && right >= 0 && Double.isFinite(left + centre + right))) {
      throw new IllegalArgumentException(
          "clearance of " + left + " m, " + centre + " m, " + right + " m is not finite and >= 0");
    }
  }

  /** The minimum of the three, metres. */
  public double min() {
    return Math.min(centre, Math.min(left, right));
  }
}
