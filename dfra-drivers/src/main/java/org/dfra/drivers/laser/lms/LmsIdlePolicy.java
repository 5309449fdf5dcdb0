package org.dfra.drivers.laser.lms;

import java.time.Duration;
import org.dfra.core.module.ParameterTable;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.link.Ticker;

/**
 * Decides whether the laser may be idle because it has no clients. Safe for use by several threads.
 */
final class LmsIdlePolicy {

  private final Ticker ticker;
  private volatile Duration idleAfter;
  private volatile int clients;
  private volatile long usedNanos;

  /**
   * @param idleAfter time without use after which it may be idle; zero: never
   */
  LmsIdlePolicy(Ticker ticker, Duration idleAfter) {
    this.ticker = ticker;
    this.idleAfter = idleAfter;
    used();
  }

  void declareIn(ParameterTable table) {
    table.declareNumber(
        "idle_timeout",
        "without clients before it stops sending, 0 is never",
        NumberRange.of(0, 3600, "s"),
        this::idleSeconds,
        this::setIdleSeconds);
  }

  /** The laser is used now. */
  void used() {
    usedNanos = ticker.nanos();
  }

  void setClients(int number) {
    used();
    clients = number;
  }

  double idleSeconds() {
    return idleAfter.toMillis() / 1e3;
  }

  void setIdleSeconds(double seconds) {
    idleAfter = Duration.ofMillis(Math.round(1e3 * seconds));
  }

  /** Whether it may be idle now. */
  boolean mayIdle() {
    return clients == 0 && !idleAfter.isZero() && ticker.nanos() - usedNanos > idleAfter.toNanos();
  }
}
