package org.dfra.drivers.gyro.kvh;

import java.util.Locale;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;

/**
 * Estimates the bias of a stationary gyro as the mean of its readings, and checks that it is
 * plausible. Confined to one thread at a time.
 */
final class StationaryBiasEstimator {

  /** Number of readings: 5 s. */
  static final int READINGS = 500;

  /** Upper bound of the noise of a stationary gyro, standard deviation, degrees per second. */
  static final double MOST_SPREAD = 0.5;

  /** Upper bound of the bias, degrees per second; the manufacturer states 20 degrees per hour. */
  static final double MOST_BIAS = 1;

  private int count;
  private double mean; // rad/s
  private double squares; // sum of squared differences from the mean, (rad/s)²

  /** Adds a rate, radians per second; returns whether it was the last that is needed. */
  boolean add(double rate) {
    count++;
    double difference = rate - mean;
    mean += difference / count;
    squares += difference * (rate - mean);
    return count >= READINGS;
  }

  /** The bias, radians per second; only where {@link #finding} has passed. */
  double bias() {
    return mean;
  }

  DiagnosticFinding finding() {
    double spread = Math.toDegrees(Math.sqrt(squares / count));
    double bias = Math.toDegrees(mean);
    if (spread > MOST_SPREAD) {
      return new DiagnosticFinding(
          false,
          String.format(
              Locale.ROOT,
              "it is moving: its rates differ by %.3f °/s > %.3f °/s (standard deviation of %d"
                  + " readings); keep it still and try again",
              spread,
              MOST_SPREAD,
              count));
    }
    if (Math.abs(bias) > MOST_BIAS) {
      return new DiagnosticFinding(
          false,
          String.format(
              Locale.ROOT,
              "it is moving: it turns by %.3f °/s, and no bias is greater than %.3f °/s; keep it"
                  + " still and try again",
              bias,
              MOST_BIAS));
    }
    return new DiagnosticFinding(
        true,
        String.format(
            Locale.ROOT,
            "the bias is %.6f rad/s, the mean of %d readings with a standard deviation of %.4f °/s;"
                + " it is taken off from now on",
            mean,
            count,
            spread));
  }
}
