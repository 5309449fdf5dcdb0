package org.dfra.sim.physics;

import java.time.Instant;

/** The wheels of a skid-steered robot, as their controller moves and measures them. */
public interface DrivetrainPhysics {

  /**
   * What the encoders have counted since the robot was put into the world: the motion of the
   * wheels, which slip, not that of the robot.
   *
   * @param distance mean of both sides, metres, forward is +
   * @param yaw right side less left side over the track, radians, to the left is +
   * @param speed of the wheels now, metres per second, forward is +
   * @param yawRate of the wheels now, radians per second, to the left is +
   */
  record Travel(double distance, double yaw, double speed, double yawRate) {}

  /**
   * Wants the wheels to turn so from now on; they get there by the accelerations given, and no
   * faster than the motors can.
   *
   * @param speed metres per second, forward is +
   * @param yawRate radians per second, to the left is +
   * @param acceleration metres per second squared, above 0
   * @param yawAcceleration radians per second squared, above 0
   */
  void drive(
      Instant time, double speed, double yawRate, double acceleration, double yawAcceleration);

  /** Sets or releases the brakes. While they are set the wheels stand or come to stand. */
  void brake(Instant time, boolean set);

  /** What the encoders have counted by {@code time}. */
  Travel travel(Instant time);
}
