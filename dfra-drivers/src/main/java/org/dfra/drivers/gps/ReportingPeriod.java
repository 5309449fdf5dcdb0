package org.dfra.drivers.gps;

import java.time.Duration;

/** How often a receiver reports its position. Safe for use by several threads. */
public interface ReportingPeriod {

  /** Currently configured time from one position to the next, seconds. */
  double seconds();

  /** Maximum age of a position, and maximum silence of the receiver: three periods and 2 s. */
  default Duration longestAge() {
    return Duration.ofMillis(Math.round(3000 * seconds()) + 2000);
  }

  /** A position has been received. */
  default void arrived() {}
}
