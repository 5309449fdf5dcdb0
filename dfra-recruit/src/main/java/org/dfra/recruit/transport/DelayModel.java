package org.dfra.recruit.transport;

import java.util.random.RandomGenerator;

/** Models the delay of messages. */
@FunctionalInterface
public interface DelayModel {

  /**
   * The delay of the next message, seconds, not negative.
   *
   * @param random source of random numbers
   */
  double next(RandomGenerator random);

  /** A constant delay. */
  static DelayModel constant(double seconds) {
    return lot -> seconds;
  }
}
