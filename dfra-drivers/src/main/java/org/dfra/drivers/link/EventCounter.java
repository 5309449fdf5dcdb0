package org.dfra.drivers.link;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Counts events of a device or its link by name (for example a message's ID), for tests and
 * recoveries that wait for the next one. Safe for use by several threads.
 */
public final class EventCounter {

  private final Ticker ticker;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed;

  @GuardedBy("lock")
  private final Map<String, Long> counts = new HashMap<>();

  /**
   * @param ticker the clock for waits
   */
  public EventCounter(Ticker ticker) {
    this.ticker = ticker;
    this.changed = ticker.newCondition(lock);
  }

  /** Counts one event. */
  public void increment(String event) {
    lock.lock();
    try {
      counts.merge(event, 1L, Long::sum);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Number of events so far. */
  public long total(String event) {
    lock.lock();
    try {
      return counts.getOrDefault(event, 0L);
    } finally {
      lock.unlock();
    }
  }

  /** Waits until the count exceeds {@code before}; false after the timeout. */
  public boolean await(String event, long before, Duration timeout) throws InterruptedException {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = timeout.toNanos();
      while (counts.getOrDefault(event, 0L) <= before && left > 0) {
        ticker.await(changed, left);
        left = timeout.toNanos() - (ticker.nanos() - begin);
      }
      return counts.getOrDefault(event, 0L) > before;
    } finally {
      lock.unlock();
    }
  }
}
