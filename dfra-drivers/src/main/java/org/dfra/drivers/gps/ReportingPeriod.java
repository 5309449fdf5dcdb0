package org.dfra.drivers.gps;

import java.time.Duration;
import org.dfra.core.config.Parameters;

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

  /**
   * The reporting period of a receiver that is configured with another tool: the parameter {@code
   * period}.
   *
   * @param seconds from one position to the next
   */
  record FixedReportingPeriod(double seconds) implements ReportingPeriod {

    /**
     * Reads {@code period}: seconds from one position to the next, 0.02 to 3600; default 1.
     *
     * @throws org.dfra.core.config.ConfigurationException if it is set to anything else
     */
    public static FixedReportingPeriod from(Parameters parameters) {
      return new FixedReportingPeriod(parameters.number("period", 1, 0.02, 3600));
    }
  }
}
