package org.dfra.river.bootstrap;

import java.io.EOFException;
import java.io.IOException;
import java.net.SocketException;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.UnmarshalException;
import java.rmi.activation.ActivationException;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import org.dfra.river.call.DeadlineExceededException;
import org.jspecify.annotations.Nullable;

/**
 * The time limit of a command. On a busy computer a response sometimes misses its deadline, so an
 * idempotent call is retried until the limit.
 */
final class RetryDeadline {

  private static final String ASKED = "phoenix, or what it has started,";
  private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

  private final Duration time;
  private final LongSupplier nanos;
  private final Runnable pause;
  private final long end;

  /**
   * @param time time limit of the command, from now
   * @param nanos a monotonic clock, in nanoseconds
   * @param pause waits briefly, so that a refused connection is not retried in a tight loop
   */
  RetryDeadline(Duration time, LongSupplier nanos, Runnable pause) {
    this.time = time;
    this.nanos = nanos;
    this.pause = pause;
    this.end = nanos.getAsLong() + time.toNanos();
  }

  /** Uses this machine's clock. */
  static RetryDeadline of(Duration time) {
    return new RetryDeadline(time, System::nanoTime, () -> LockSupport.parkNanos(PAUSE_NANOS));
  }

  /** A call that may be repeated: a query, or a change that is made only if needed. */
  interface IdempotentCall<T> {
    T call() throws IOException, ActivationException;
  }

  /**
   * Makes the call and returns its result. The call is repeated only if no answer arrives; a
   * refusal is an answer.
   *
   * @throws NoAnswerException if no answer arrived within the time limit
   * @throws IOException as the call does
   * @throws ActivationException as the call does; also if phoenix received no answer to its own
   *     call
   */
  <T> T call(IdempotentCall<T> question) throws IOException, ActivationException {
    while (true) {
      try {
        return question.call();
      } catch (IOException | ActivationException e) {
        if (!isUnanswered(e)) {
          throw e;
        }
        if (isExpired()) {
          if (e instanceof ActivationException) {
            throw e;
          }
          throw new NoAnswerException(ASKED, time, e);
        }
        pause();
      }
    }
  }

  /** A call without a result that may be repeated. */
  interface IdempotentAction {
    void run() throws IOException, ActivationException;
  }

  /** Runs an action; as {@link #call}. */
  void run(IdempotentAction action) throws IOException, ActivationException {
    Boolean unused =
        call(
            () -> {
              action.run();
              return true;
            });
  }

  /** The time limit of the command. */
  Duration timeout() {
    return time;
  }

  /** Whether the command's time limit has passed. */
  boolean isExpired() {
    return nanos.getAsLong() - end >= 0;
  }

  /** Waits briefly. */
  void pause() {
    pause.run();
  }

  /** Whether no answer arrived, as opposed to a refusal. */
  static boolean isUnanswered(Throwable failure) {
    if (isCutOff(failure)) {
      return true;
    }
    for (@Nullable Throwable at = failure; at != null; at = at.getCause()) {
      if (at instanceof DeadlineExceededException
          || at instanceof ConnectException
          || at instanceof ConnectIOException) {
        return true;
      }
    }
    return false;
  }

  /** Whether the connection ended during the call itself. */
  private static boolean isCutOff(Throwable failure) {
    return (failure instanceof MarshalException || failure instanceof UnmarshalException)
        && (failure.getCause() instanceof EOFException
            || failure.getCause() instanceof SocketException);
  }
}
