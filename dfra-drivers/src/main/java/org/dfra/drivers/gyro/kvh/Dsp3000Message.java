package org.dfra.drivers.gyro.kvh;

/** The content of one line of the gyro. */
sealed interface Dsp3000Message {

  /**
   * A rate, in the mode {@code R}.
   *
   * @param degreesPerSecond about its axis; seen from its upper side, clockwise is +
   * @param isValid whether the gyro reports it as valid; false while it starts, and when it is
   *     defective
   */
  record Rate(double degreesPerSecond, boolean isValid) implements Dsp3000Message {}

  /**
   * A line with an invalid value.
   *
   * @param line the line
   */
  record Malformed(String line) implements Dsp3000Message {}
}
