package org.dfra.sim.physics;

import java.time.Instant;

/** The wheels of a skid-steered robot, as their controller moves and measures them. */
public interface DrivetrainPhysics {

  /**
   * Encoder counts since the robot was created: the motion of the wheels, which slip, not that of
   * the robot.
   *
   * @param distance mean of both sides, metres, forward is +
   * @param yaw right side less left side over the track, radians, to the left is +
   * @param speed of the wheels now, metres per second, forward is +
   * @param yawRate of the wheels now, radians per second, to the left is +
   */
  record Travel(double distance, double yaw, double speed, double yawRate) {}

  /**
   * Sets the wheels' target velocity; they reach it with the given accelerations, limited by the
   * motors.
   *
   * @param speed metres per second, forward is +
   * @param yawRate radians per second, to the left is +
   * @param acceleration metres per second squared, above 0
   * @param yawAcceleration radians per second squared, above 0
   */
  void drive(
      Instant time, double speed, double yawRate, double acceleration, double yawAcceleration);

  /** Sets or releases the brakes. While they are set the wheels stop. */
  void brake(Instant time, boolean set);

  /** Encoder counts at {@code time}. */
  Travel travel(Instant time);
}
