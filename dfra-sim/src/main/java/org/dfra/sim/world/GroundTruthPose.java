package org.dfra.sim.world;

import java.time.Instant;

/**
 * True pose and velocity of a robot, in the world's frame.
 *
 * @param time of the step
 * @param east of its centre, metres
 * @param north of its centre, metres
 * @param up of its base, metres above the ground
 * @param roll radians, left side up is +
 * @param pitch radians, nose down is +
 * @param yaw radians, −π to π, 0 is east, counter-clockwise is +
 * @param eastward velocity, metres per second
 * @param northward velocity, metres per second
 * @param upward velocity, metres per second
 * @param yawRate radians per second, counter-clockwise is +
 */
public record GroundTruthPose(
    Instant time,
    double east,
    double north,
    double up,
    double roll,
    double pitch,
    double yaw,
    double eastward,
    double northward,
    double upward,
    double yawRate) {

  /** Speed over ground, metres per second. */
  public double speed() {
    return Math.sqrt(eastward * eastward + northward * northward);
  }
}
