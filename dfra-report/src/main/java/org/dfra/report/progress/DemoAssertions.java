package org.dfra.report.progress;

import java.io.IOException;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** The assertions of a demonstration. */
public final class DemoAssertions {

  private static final long LOOK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(5);

  private DemoAssertions() {}

  /** Fails with the message unless the condition holds. */
  public static void require(boolean condition, String otherwise) throws IOException {
    if (!condition) {
      throw new IOException(otherwise);
    }
  }

  /**
   * Waits until a condition holds. Polls every 5 ms, since the state belongs to other processes or
   * has no change notification.
   *
   * @param what the condition, as the end of "… did not happen"
   */
  public static void await(String what, Duration patience, Callable<Boolean> condition)
      throws Exception {
    if (!holdsWithin(patience, condition)) {
      throw new IOException(what + " did not happen within " + patience.toSeconds() + " s");
    }
  }

  /** Waits likewise, without failing: returns whether the condition held in time. */
  public static boolean holdsWithin(Duration patience, Callable<Boolean> condition)
      throws Exception {
    long end = System.nanoTime() + patience.toNanos();
    while (!condition.call()) {
      if (System.nanoTime() - end > 0) {
        return false;
      }
      LockSupport.parkNanos(LOOK_AGAIN_NANOS);
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
    }
    return true;
  }
}
