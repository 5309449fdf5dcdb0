package org.dfra.drivers.gps.m12;

import java.time.Duration;
import org.dfra.core.config.Parameters;
import org.dfra.drivers.gps.ReportingPeriod;

/**
 * How often the receiver is to tell its position: at one rate while it has clients, at another,
 * slower one while it rests. Also how old a position may be, which follows the rate.
 *
 * <p>When the rate goes up, positions are judged by the slower one until the first at the new rate
 * has come. Safe for use by several threads.
 */
final class M12ReportingPeriod implements ReportingPeriod {

  /** Seconds; the receiver takes no more. */
  static final int LONGEST = 255;

  private int working; // all guarded by this
  private int idle;
  private boolean isIdle;
  private int judgedBy;

  /**
   * @param working seconds between positions while it works
   * @param idle seconds between positions while it rests
   */
  M12ReportingPeriod(int working, int idle) {
    this.working = working;
    this.idle = idle;
    this.judgedBy = working;
  }

  /**
   * Reads {@code rate} and {@code idle_rate}.
   *
   * @throws org.dfra.core.config.ConfigurationException if one is no number of seconds it can be
   */
  static M12ReportingPeriod from(Parameters parameters) {
    return new M12ReportingPeriod(
        seconds(parameters, "rate", 1), seconds(parameters, "idle_rate", 10));
  }

  private static int seconds(Parameters parameters, String name, int fallback) {
    double seconds = parameters.number(name, fallback, 1, LONGEST);
    if (seconds != Math.rint(seconds)) {
      throw parameters.fault(name, "a whole number of seconds", null);
    }
    return (int) seconds;
  }

  @Override
  public double seconds() {
    return now();
  }

  synchronized int working() {
    return working;
  }

  synchronized int idle() {
    return idle;
  }

  synchronized void setWorking(int seconds) {
    working = seconds;
    judgedBy = Math.max(judgedBy, now());
  }

  synchronized void setIdle(int seconds) {
    idle = seconds;
    judgedBy = Math.max(judgedBy, now());
  }

  synchronized void setIdleMode(boolean idleNow) {
    isIdle = idleNow;
    judgedBy = Math.max(judgedBy, now());
  }

  /** Seconds between positions, as wanted now. */
  synchronized int now() {
    return isIdle ? Math.max(idle, working) : working;
  }

  /** A position has come at the rate that is wanted now. */
  synchronized void arrivedAtThisRate() {
    judgedBy = now();
  }

  @Override
  public synchronized Duration longestAge() {
    return Duration.ofSeconds(3L * judgedBy + 2);
  }
}
