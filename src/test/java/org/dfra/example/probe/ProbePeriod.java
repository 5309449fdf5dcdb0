package org.dfra.example.probe;

import java.time.Duration;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ParameterTable;
import org.dfra.core.module.ParameterTable.NumberRange;

/**
 * How often the probe sends its temperature: the parameters {@code period} and {@code idle_period}.
 * Safe for use by several threads.
 */
final class ProbePeriod {

  private static final NumberRange RANGE = NumberRange.of(1, 60, "s");

  private final double idlePeriod;
  private volatile double period;
  private volatile boolean isIdle;

  ProbePeriod(Parameters written) {
    period = written.number("period", 1, 1, 60);
    idlePeriod = written.number("idle_period", 10, 1, 60);
  }

  void declareIn(ParameterTable table) {
    table.declareNumber("period", "between readings", RANGE, () -> period, value -> period = value);
  }

  void setIdle(boolean isIdle) {
    this.isIdle = isIdle;
  }

  /** Seconds from one reading to the next, as wanted now. */
  double seconds() {
    return isIdle ? Math.max(period, idlePeriod) : period;
  }

  /**
   * How long a probe that was set to this pace may be silent: three periods and 2 s.
   *
   * @param seconds from one reading to the next
   */
  static Duration patience(double seconds) {
    return Duration.ofMillis(Math.round(3000 * seconds) + 2000);
  }

  /** For people: {@code 5.0 s}. */
  static String inWords(Duration patience) {
    return patience.toMillis() / 1e3 + " s";
  }
}
