package org.dfra.core.effector;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongConsumer;
import org.dfra.core.time.SerialExecutor;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Notices that a command has not been followed by another in time. The timer is one that no driver
 * can hold up, and nothing here waits for a lock that a driver may hold.
 *
 * <pre>
 *   idle --began--&gt; watching --began--&gt; watching, from now on
 *   watching --ended--&gt; idle
 *   watching --silence--&gt; whenOver(number), until it has ended
 * </pre>
 */
final class CommandTimeout {

  private final Scheduler scheduler;

  /** Runs nothing but time-outs: see {@link Scheduler#commandTimer}. */
  private final Scheduler timer;

  private final SerialExecutor thread;
  private final LongConsumer whenOver;

  private volatile double seconds;
  private volatile long lastNanos; // when the last command came

  /** Written under this. A watch that has not this number does nothing. */
  private final AtomicLong timerNumber = new AtomicLong();

  private @Nullable ScheduledTask
      timerTask; // guarded by this; the first of those with the same number

  /**
   * @param thread runs {@code whenOver}
   * @param seconds the longest silence
   * @param whenOver is given the number of the watch; see {@link #isCurrent}
   */
  CommandTimeout(
      Scheduler scheduler, SerialExecutor thread, double seconds, LongConsumer whenOver) {
    this.scheduler = scheduler;
    this.timer = scheduler.commandTimer();
    this.thread = thread;
    this.seconds = seconds;
    this.whenOver = whenOver;
  }

  /** The longest silence, seconds. */
  double seconds() {
    return seconds;
  }

  /** The same, nanoseconds. */
  long nanos() {
    return Math.round(seconds * 1e9);
  }

  /** Sets the longest silence; it counts for the command that came last, too. */
  synchronized void setSeconds(double longest) {
    seconds = longest;
    if (timerTask != null) {
      restart(leftNanos());
    }
  }

  /**
   * A command has come that another must follow.
   *
   * @throws OutOfMemoryError if it could not be watched, since there cannot be one more thread
   */
  synchronized void commandReceived() {
    thread.prepare();
    lastNanos = scheduler.nanos();
    if (timerTask == null) {
      restart(leftNanos());
    }
  }

  /** None need follow any more. */
  synchronized void cancel() {
    timerNumber.incrementAndGet();
    if (timerTask != null) {
      timerTask.cancel();
      timerTask = null;
    }
  }

  /** Whether the watch of this number is still kept. */
  boolean isCurrent(long number) {
    return number == timerNumber.get();
  }

  /** Whether the last command is too old. */
  boolean isExpired() {
    return leftNanos() <= 0;
  }

  /** Looks again when it may be over; for one whose command has been followed by another. */
  void recheckLater(long number) {
    ScheduledTask unused = lookAfter(leftNanos(), number);
  }

  private long leftNanos() {
    return nanos() - (scheduler.nanos() - lastNanos);
  }

  private void restart(long nanos) {
    cancel();
    timerTask = lookAfter(nanos, timerNumber.get());
  }

  private ScheduledTask lookAfter(long nanos, long number) {
    return timer.after(nanos, () -> thread.execute(() -> look(number)));
  }

  /** On the thread for it, without a lock, which a driver may have. */
  private void look(long number) {
    if (!isCurrent(number)) {
      return;
    }
    if (isExpired()) {
      whenOver.accept(number);
    } else {
      recheckLater(number);
    }
  }
}
