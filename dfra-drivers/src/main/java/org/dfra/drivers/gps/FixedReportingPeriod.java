package org.dfra.drivers.gps;

import org.dfra.core.config.Parameters;

/**
 * The reporting period of a receiver that is configured with another tool: the parameter {@code
 * period}.
 *
 * @param seconds from one position to the next
 */
public record FixedReportingPeriod(double seconds) implements ReportingPeriod {

  /**
   * Reads {@code period}: seconds from one position to the next, 0.02 to 3600; default 1.
   *
   * @throws org.dfra.core.config.ConfigurationException if it is set to anything else
   */
  public static FixedReportingPeriod from(Parameters parameters) {
    return new FixedReportingPeriod(parameters.number("period", 1, 0.02, 3600));
  }
}
