package org.dfra.drivers.gps.m12;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import org.dfra.core.config.Parameters;
import org.dfra.drivers.gps.ReportingPeriod;

/**
 * How often the receiver reports its position: one rate with clients, a slower one while idle. It
 * also determines the maximum age of a position, which follows the rate.
 *
 * <p>When the rate increases, the slower rate determines the maximum age until the first position
 * at the new rate arrives. Safe for use by several threads.
 */
final class M12ReportingPeriod implements ReportingPeriod {

  /** Maximum that the receiver accepts, seconds. */
  static final int LONGEST = 255;

  @GuardedBy("this")
  private int working;

  @GuardedBy("this")
  private int idle;

  @GuardedBy("this")
  private boolean isIdle;

  @GuardedBy("this")
  private int judgedBy;

  /**
   * @param working seconds between positions with clients
   * @param idle seconds between positions while idle
   */
  M12ReportingPeriod(int working, int idle) {
    this.working = working;
    this.idle = idle;
    this.judgedBy = working;
  }

  /**
   * Reads {@code period} and {@code idle_period}.
   *
   * @throws org.dfra.core.config.ConfigurationException if one is not a valid number of seconds
   */
  static M12ReportingPeriod from(Parameters parameters) {
    return new M12ReportingPeriod(
        seconds(parameters, "period", 1), seconds(parameters, "idle_period", 10));
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

  /** Currently required time between positions, seconds. */
  synchronized int now() {
    return isIdle ? Math.max(idle, working) : working;
  }

  /** A position has been received at the currently required rate. */
  synchronized void arrivedAtThisRate() {
    judgedBy = now();
  }

  @Override
  public synchronized Duration longestAge() {
    return Duration.ofSeconds(3L * judgedBy + 2);
  }
}
