package org.dfra.recruit.transport;

import java.util.random.RandomGenerator;

/** For how long letters are on their way. */
@FunctionalInterface
public interface DelayModel {

  /**
   * That of the next one, seconds, not negative.
   *
   * @param random what it is drawn by
   */
  double next(RandomGenerator random);

  /** Always the same. */
  static DelayModel constant(double seconds) {
    return lot -> seconds;
  }
}
