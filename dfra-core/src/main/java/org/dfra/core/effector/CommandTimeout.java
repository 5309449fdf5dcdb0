package org.dfra.core.effector;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongConsumer;
import org.dfra.core.time.SerialExecutor;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Detects that no command has followed the last one in time. No driver can block its timer, and
 * nothing here waits for a lock that a driver may hold.
 *
 * <pre>
 *   idle --commandReceived--&gt; watching --commandReceived--&gt; watching, restarted
 *   watching --cancel--&gt; idle
 *   watching --timeout--&gt; whenOver(number), until cancelled
 * </pre>
 */
final class CommandTimeout {

  private final Scheduler scheduler;

  /** Runs only command timeouts: see {@link Scheduler#commandTimer}. */
  private final Scheduler timer;

  private final SerialExecutor thread;
  private final LongConsumer whenOver;

  private volatile double seconds;
  private volatile long lastNanos; // when the last command was received

  /** Written with the lock of this held. A timer with another number does nothing. */
  private final AtomicLong timerNumber = new AtomicLong();

  /** The first task with the current number. */
  @GuardedBy("this")
  private @Nullable ScheduledTask timerTask;

  /**
   * @param thread runs {@code whenOver}
   * @param seconds the command timeout
   * @param whenOver receives the number of the timer; see {@link #isCurrent}
   */
  CommandTimeout(
      Scheduler scheduler, SerialExecutor thread, double seconds, LongConsumer whenOver) {
    this.scheduler = scheduler;
    this.timer = scheduler.commandTimer();
    this.thread = thread;
    this.seconds = seconds;
    this.whenOver = whenOver;
  }

  /** The command timeout, seconds. */
  double seconds() {
    return seconds;
  }

  /** The same, nanoseconds. */
  long nanos() {
    return Math.round(seconds * 1e9);
  }

  /** Sets the command timeout; it also applies to the last command. */
  synchronized void setSeconds(double longest) {
    seconds = longest;
    if (timerTask != null) {
      restart(leftNanos());
    }
  }

  /**
   * Starts the timeout after a command that another must follow.
   *
   * @throws OutOfMemoryError if the timer could not be started, since no thread could be created
   */
  synchronized void commandReceived() {
    thread.prepare();
    lastNanos = scheduler.nanos();
    if (timerTask == null) {
      restart(leftNanos());
    }
  }

  /** Cancels the timeout: no further command is required. */
  synchronized void cancel() {
    timerNumber.incrementAndGet();
    if (timerTask != null) {
      timerTask.cancel();
      timerTask = null;
    }
  }

  /** Whether the timer of this number is still active. */
  boolean isCurrent(long number) {
    return number == timerNumber.get();
  }

  /** Whether the last command is too old. */
  boolean isExpired() {
    return leftNanos() <= 0;
  }

  /**
   * Checks again when the timeout may expire, for a timer whose command was followed by another.
   */
  void recheckLater(long number) {
    ScheduledTask unused = lookAfter(leftNanos(), number);
  }

  private long leftNanos() {
    return nanos() - (scheduler.nanos() - lastNanos);
  }

  @GuardedBy("this")
  private void restart(long nanos) {
    cancel();
    timerTask = lookAfter(nanos, timerNumber.get());
  }

  private ScheduledTask lookAfter(long nanos, long number) {
    return timer.after(nanos, () -> thread.execute(() -> look(number)));
  }

  /** On the timer's thread, without a lock that a driver may hold. */
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
