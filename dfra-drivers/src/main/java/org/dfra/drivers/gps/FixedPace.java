package org.dfra.drivers.gps;

import org.dfra.core.config.Parameters;

/**
 * The pace of a receiver that is set to it elsewhere: the parameter {@code period}.
 *
 * @param seconds from one position to the next
 */
public record FixedPace(double seconds) implements Pace {

  /**
   * Reads {@code period}: seconds from one position to the next, 0.02 to 3600; default 1.
   *
   * @throws org.dfra.core.config.ConfigurationException if it is set to anything else
   */
  public static FixedPace in(Parameters parameters) {
    return new FixedPace(parameters.number("period", 1, 0.02, 3600));
  }
}
