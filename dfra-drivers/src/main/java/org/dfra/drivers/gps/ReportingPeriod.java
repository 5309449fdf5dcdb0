package org.dfra.drivers.gps;

import java.time.Duration;

/** How often a receiver tells its position. Safe for use by several threads. */
public interface ReportingPeriod {

  /** Seconds from one position to the next, as wanted now. */
  double seconds();

  /** How old a position may be, and how long the receiver silent: three periods and 2 s. */
  default Duration longestAge() {
    return Duration.ofMillis(Math.round(3000 * seconds()) + 2000);
  }

  /** A position has come. */
  default void arrived() {}
}
