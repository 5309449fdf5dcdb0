package org.dfra.river.discovery;

import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Delays the retries of a listener whose socket fails. Before the socket is opened again, the
 * listener waits 0.1, 0.2, 0.4 seconds and so on, up to 30 s, until the socket works or the
 * listener is closed. A network outage of an hour costs two attempts a minute and one line in the
 * log.
 *
 * <p>Threads: the listener's own, and any for {@link #close} and {@link #isClosed}.
 */
final class ReopenBackoff implements AutoCloseable {

  static final Duration SHORTEST = Duration.ofMillis(100);
  static final Duration LONGEST = Duration.ofSeconds(30);

  private static final int DOUBLINGS = 9; // 51 s, more than the maximum

  private final CountDownLatch closed = new CountDownLatch(1);
  private int failures; // in a row

  /**
   * The socket failed, or could not be opened.
   *
   * @return whether this is the first failure in a row, which is the one to log
   */
  boolean failed() {
    failures++;
    return failures == 1;
  }

  /**
   * The socket works.
   *
   * @return whether it had failed before
   */
  boolean succeeded() {
    boolean isBack = failures > 0;
    failures = 0;
    return isBack;
  }

  /** The next delay; zero after no failure. */
  Duration pause() {
    if (failures == 0) {
      return Duration.ZERO;
    }
    Duration pause = SHORTEST.multipliedBy(1L << Math.min(DOUBLINGS, failures - 1));
    return pause.compareTo(LONGEST) < 0 ? pause : LONGEST;
  }

  /**
   * Waits until the next attempt is due.
   *
   * @return whether to make the attempt; false immediately when the listener is closed
   */
  boolean await() {
    try {
      return !closed.await(pause().toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) { // only close() ends a listener
      return !isClosed();
    }
  }

  boolean isClosed() {
    return closed.getCount() == 0;
  }

  /** Ends the wait. Idempotent. */
  @Override
  public void close() {
    closed.countDown();
  }
}
