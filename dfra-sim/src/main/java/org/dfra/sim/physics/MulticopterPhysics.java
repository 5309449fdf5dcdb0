package org.dfra.sim.physics;

import java.time.Instant;

/** A multicopter under its autopilot: it flies to commanded positions by its own dynamics. */
public interface MulticopterPhysics {

  /**
   * Its true state.
   *
   * @param east metres from the world's datum
   * @param north metres from the world's datum
   * @param up metres above the ground, not negative
   * @param yaw heading of its nose, radians, 0 is east, counter-clockwise is +
   * @param eastward velocity, metres per second
   * @param northward velocity, metres per second
   * @param upward velocity, metres per second
   * @param rotorsTurning whether its rotors run
   */
  record MulticopterState(
      double east,
      double north,
      double up,
      double yaw,
      double eastward,
      double northward,
      double upward,
      boolean rotorsTurning) {}

  /** Starts or stops its rotors; in the air they cannot be stopped and nothing happens. */
  void rotors(Instant time, boolean on);

  /**
   * Flies in a straight line to a position and stays. Does nothing while the rotors are stopped.
   *
   * @param east metres from the world's datum
   * @param north metres from the world's datum
   * @param up metres above the ground; 0 lands
   * @param speed metres per second, above 0; limited by the vehicle
   */
  void fly(Instant time, double east, double north, double up, double speed);

  /** Its state at {@code time}. */
  MulticopterState at(Instant time);
}
