package org.dfra.core.lease;

import java.math.BigDecimal;
import java.time.Duration;
import org.dfra.lease.LeaseRefusedException;

/**
 * The terms of the leases that a module grants.
 *
 * @param maxDuration the maximum duration, at least a millisecond
 * @param defaultDuration the default duration, not longer
 */
public record LeaseTerms(Duration maxDuration, Duration defaultDuration) {

  /** Maximum 30 seconds, default 10 seconds. */
  public static final LeaseTerms DEFAULT =
      new LeaseTerms(Duration.ofSeconds(30), Duration.ofSeconds(10));

  private static final int MILLI = 3;

  public LeaseTerms {
    if (defaultDuration.toMillis() < 1 || defaultDuration.compareTo(maxDuration) > 0) {
      throw new IllegalArgumentException(
          "usual lease "
              + seconds(defaultDuration)
              + " is outside 0.001 s to the longest "
              + seconds(maxDuration));
    }
  }

  /**
   * Throws if a requested duration is not allowed.
   *
   * @param module the module's path, for the message
   * @throws LeaseRefusedException if {@code asked} is longer than the maximum or not above zero
   */
  public void check(String module, Duration asked) throws LeaseRefusedException {
    boolean tooShort = asked.isNegative() || asked.isZero();
    if (tooShort || asked.compareTo(maxDuration) > 0) {
      throw new LeaseRefusedException(
          module
              + ": lease "
              + seconds(asked)
              + (tooShort ? " is not above 0" : " > longest allowed " + seconds(maxDuration))
              + "; ask for "
              + seconds(maxDuration)
              + " or less");
    }
  }

  /** 30 s rather than 30.0 s. */
  private static String seconds(Duration duration) {
    if (duration.getSeconds() >= Long.MAX_VALUE / 1000) {
      return "for ever";
    }
    return BigDecimal.valueOf(duration.toMillis(), MILLI).stripTrailingZeros().toPlainString()
        + " s";
  }
}
