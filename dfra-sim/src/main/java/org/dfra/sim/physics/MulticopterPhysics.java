package org.dfra.sim.physics;

import java.time.Instant;

/** A multicopter as its autopilot flies it: goes where it is told, by its own dynamics. */
public interface MulticopterPhysics {

  /**
   * Where it truly is.
   *
   * @param east metres from the world's datum
   * @param north metres from the world's datum
   * @param up metres above the ground, not negative
   * @param yaw heading of its nose, radians, 0 is east, counter-clockwise is +
   * @param eastward velocity, metres per second
   * @param northward velocity, metres per second
   * @param upward velocity, metres per second
   * @param rotorsTurning whether its rotors turn
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
   * Flies in a straight line to there and stays. Does nothing while the rotors stand.
   *
   * @param east metres from the world's datum
   * @param north metres from the world's datum
   * @param up metres above the ground; 0 lands
   * @param speed metres per second, above 0; it flies no faster than it can
   */
  void fly(Instant time, double east, double north, double up, double speed);

  /** Where it is at {@code time}. */
  MulticopterState at(Instant time);
}
