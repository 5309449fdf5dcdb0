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
 * The time that a command has. On a busy computer an answer misses its deadline now and then, so a
 * question that may be asked twice is asked again until that time is over.
 */
final class RetryDeadline {

  private static final String ASKED = "phoenix, or what it has started,";
  private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

  private final Duration time;
  private final LongSupplier nanos;
  private final Runnable pause;
  private final long end;

  /**
   * @param time how long the command may take from now on
   * @param nanos a clock that is never set, in nanoseconds
   * @param pause waits a moment, so that a refused connection is not tried in a tight loop
   */
  RetryDeadline(Duration time, LongSupplier nanos, Runnable pause) {
    this.time = time;
    this.nanos = nanos;
    this.pause = pause;
    this.end = nanos.getAsLong() + time.toNanos();
  }

  /** By this machine's clock. */
  static RetryDeadline of(Duration time) {
    return new RetryDeadline(time, System::nanoTime, () -> LockSupport.parkNanos(PAUSE_NANOS));
  }

  /** Something that may be done twice: a question, or a change that is made only where needed. */
  interface IdempotentCall<T> {
    T call() throws IOException, ActivationException;
  }

  /**
   * The answer. Only where none comes is the question asked again; a refusal is an answer.
   *
   * @throws NoAnswerException if no answer came when the time is over
   * @throws IOException as the question does
   * @throws ActivationException likewise; also if no answer came from what phoenix asked itself
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

  /** Something that may be done twice and has no answer but that it was done. */
  interface IdempotentAction {
    void run() throws IOException, ActivationException;
  }

  /** Has something done; as {@link #call}. */
  void run(IdempotentAction action) throws IOException, ActivationException {
    Boolean unused =
        call(
            () -> {
              action.run();
              return true;
            });
  }

  /** How long the command may take. */
  Duration timeout() {
    return time;
  }

  /** Whether the command's time is over. */
  boolean isExpired() {
    return nanos.getAsLong() - end >= 0;
  }

  /** Waits a moment. */
  void pause() {
    pause.run();
  }

  /** Whether nobody answered, rather than that somebody refused. */
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

  /** Whether the connection ended while the call itself was under way. */
  private static boolean isCutOff(Throwable failure) {
    return (failure instanceof MarshalException || failure instanceof UnmarshalException)
        && (failure.getCause() instanceof EOFException
            || failure.getCause() instanceof SocketException);
  }
}
