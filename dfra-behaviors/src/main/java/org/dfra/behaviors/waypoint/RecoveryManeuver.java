package org.dfra.behaviors.waypoint;

import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;
import org.jspecify.annotations.Nullable;

/**
 * Frees a stuck robot: it drives back, rotates towards the larger clearance, and drives a short
 * distance straight on.
 *
 * <pre>
 *   BACK --1.5 s--&gt; TURN --up to 1.5 s--&gt; ON --2.5 s--&gt; over
 * </pre>
 *
 * <p>It rotates to the side with more clearance, and to the other side every second time. Immutable
 * but for its phase; confined to one thread.
 */
final class RecoveryManeuver {

  private static final double BACK_SECONDS = 1.5;
  private static final double TURN_SECONDS = 1.5;
  private static final double ON_SECONDS = 2.5;
  private static final double BACK_SPEED = -0.25; // m/s
  private static final double YAW_RATE = 0.8; // rad/s

  private final long begun;
  private final boolean otherSide;
  private @Nullable Boolean left; // decided at the start of TURN

  /**
   * @param nanos now
   * @param attempt number of earlier ones on this leg
   */
  RecoveryManeuver(long nanos, int attempt) {
    this.begun = nanos;
    this.otherSide = attempt % 2 == 1;
  }

  /**
   * The command now.
   *
   * @return a velocity; null where the robot drives straight on with the controller; invalid once
   *     {@link #isOver}
   */
  @Nullable Velocity velocity(long nanos, Clearance clearance) {
    double seconds = (nanos - begun) / 1e9;
    if (seconds < BACK_SECONDS) {
      return new Velocity(BACK_SPEED, 0);
    }
    if (seconds < BACK_SECONDS + TURN_SECONDS) {
      Boolean decided = left;
      if (decided == null) {
        decided = (clearance.left() > clearance.right()) != otherSide;
        left = decided;
      }
      return new Velocity(0, decided ? YAW_RATE : -YAW_RATE);
    }
    return null;
  }

  boolean isOver(long nanos) {
    return (nanos - begun) / 1e9 > BACK_SECONDS + TURN_SECONDS + ON_SECONDS;
  }
}
