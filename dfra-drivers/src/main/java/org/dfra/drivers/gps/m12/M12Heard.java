package org.dfra.drivers.gps.m12;

import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.drivers.link.Ticker;

/** Counts what the receiver has said, for those who wait for the next. */
final class M12Heard {

  /** What is counted. */
  enum Sort {
    /** A link was opened. */
    OPENING,
    /** {@code @@Cj}. */
    IDENTIFICATION,
    /** {@code @@Cf}. */
    DEFAULTS,
    /** {@code @@Ha} or {@code @@Ea}, with a position or without. */
    SOLUTION
  }

  private final Ticker ticker;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition heard = lock.newCondition();
  private final Map<Sort, Long> counts = new EnumMap<>(Sort.class); // guarded by lock

  M12Heard(Ticker ticker) {
    this.ticker = ticker;
  }

  void count(Sort sort) {
    lock.lock();
    try {
      counts.merge(sort, 1L, Long::sum);
      heard.signalAll();
    } finally {
      lock.unlock();
    }
  }

  long sofar(Sort sort) {
    lock.lock();
    try {
      return counts.getOrDefault(sort, 0L);
    } finally {
      lock.unlock();
    }
  }

  /** Waits until one more has come than {@code before}; false when none has in time. */
  boolean await(Sort sort, long before, Duration patience) throws InterruptedException {
    lock.lock();
    try {
      long begin = ticker.nanos();
      long left = patience.toNanos();
      while (counts.getOrDefault(sort, 0L) <= before && left > 0) {
        ticker.await(heard, left);
        left = patience.toNanos() - (ticker.nanos() - begin);
      }
      return counts.getOrDefault(sort, 0L) > before;
    } finally {
      lock.unlock();
    }
  }
}
