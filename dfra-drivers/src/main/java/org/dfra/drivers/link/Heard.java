package org.dfra.drivers.link;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Counts what a device has said or what became of its link, by any name (a message's ID, say), for
 * those who wait for the next: tests and recoveries. Safe for use by several threads.
 */
public final class Heard {

  private final Ticker ticker;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition heard;
  private final Map<String, Long> counts = new HashMap<>(); // guarded by lock

  /**
   * @param ticker the time to wait by
   */
  public Heard(Ticker ticker) {
    this.ticker = ticker;
    this.heard = ticker.newCondition(lock);
  }

  /** One more has come. */
  public void count(String what) {
    lock.lock();
    try {
      counts.merge(what, 1L, Long::sum);
      heard.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** How many have come so far. */
  public long sofar(String what) {
    lock.lock();
    try {
      return counts.getOrDefault(what, 0L);
    } finally {
      lock.unlock();
    }
  }

  /** Waits until one more has come than {@code before}; false when none has in time. */
  public boolean await(String what, long before, Duration patience) throws InterruptedException {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = patience.toNanos();
      while (counts.getOrDefault(what, 0L) <= before && left > 0) {
        ticker.await(heard, left);
        left = patience.toNanos() - (ticker.nanos() - begin);
      }
      return counts.getOrDefault(what, 0L) > before;
    } finally {
      lock.unlock();
    }
  }
}
