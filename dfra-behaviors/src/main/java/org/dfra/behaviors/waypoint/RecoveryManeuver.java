package org.dfra.behaviors.waypoint;

import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;
import org.jspecify.annotations.Nullable;

/**
 * Gets a robot out of where it is stuck: back the way it came, a turn to where there is room, and a
 * little straight on.
 *
 * <pre>
 *   BACK --1.5 s--&gt; TURN --up to 1.5 s--&gt; ON --2.5 s--&gt; over
 * </pre>
 *
 * <p>It turns to the side with more room, and to the other side each second time. Immutable but for
 * its phase; confined to one thread.
 */
final class RecoveryManeuver {

  private static final double BACK_SECONDS = 1.5;
  private static final double TURN_SECONDS = 1.5;
  private static final double ON_SECONDS = 2.5;
  private static final double BACK_SPEED = -0.25; // m/s
  private static final double TURN_RATE = 0.8; // rad/s

  private final long begun;
  private final boolean otherSide;
  private @Nullable Boolean left; // decided when it turns

  /**
   * @param nanos now
   * @param attempt how many there have been before on this leg
   */
  RecoveryManeuver(long nanos, int attempt) {
    this.begun = nanos;
    this.otherSide = attempt % 2 == 1;
  }

  /**
   * What to do now.
   *
   * @return a velocity; null where the robot is to go straight on by the rules; nothing more is to
   *     be done once {@link #isOver}
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
      return new Velocity(0, decided ? TURN_RATE : -TURN_RATE);
    }
    return null;
  }

  boolean isOver(long nanos) {
    return (nanos - begun) / 1e9 > BACK_SECONDS + TURN_SECONDS + ON_SECONDS;
  }
}
