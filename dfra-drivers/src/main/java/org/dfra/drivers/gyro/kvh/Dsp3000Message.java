package org.dfra.drivers.gyro.kvh;

/** What one line of the gyro says. */
public sealed interface Dsp3000Message {

  /**
   * A rate, in the mode {@code R}.
   *
   * @param degreesPerSecond about its axis; seen from its upper side, clockwise is +
   * @param isValid whether the gyro vouches for it; not while it starts, nor when it is broken
   */
  record Rate(double degreesPerSecond, boolean isValid) implements Dsp3000Message {}

  /**
   * A line that says what cannot be.
   *
   * @param line the line
   */
  record Malformed(String line) implements Dsp3000Message {}
}
