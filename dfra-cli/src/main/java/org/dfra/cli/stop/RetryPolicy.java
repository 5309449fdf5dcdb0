package org.dfra.cli.stop;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dfra.river.call.DeadlineExceededException;

/**
 * The retries of a failed call: two attempts, and more while there is time if there was no answer.
 * The called computer, or the operator's, may be so loaded that an answer takes longer than one
 * attempt.
 *
 * @param attemptTimeout of one attempt
 * @param isTimeLeft whether to retry after two unanswered attempts
 */
record RetryPolicy(Duration attemptTimeout, BooleanSupplier isTimeLeft) {

  private static final int MIN_ATTEMPTS = 2;

  /**
   * After the second failure: if many calls of a peer hang, the next ones fail immediately as
   * unanswered.
   */
  static final Duration BACKOFF = Duration.ofMillis(500);

  /**
   * Makes a call with retries.
   *
   * @param once starts one attempt, which ends by itself
   * @param isFinal whether a failure is permanent
   * @return the first answer, or the last failure
   */
  <T> CompletableFuture<T> run(Supplier<CompletableFuture<T>> once, Predicate<Throwable> isFinal) {
    return run(1, once, isFinal);
  }

  private <T> CompletableFuture<T> run(
      int tries, Supplier<CompletableFuture<T>> once, Predicate<Throwable> isFinal) {
    return once.get()
        .exceptionallyCompose(
            failure -> {
              if (isFinal.test(failure)) {
                return CompletableFuture.failedFuture(failure);
              } else if (tries < MIN_ATTEMPTS) {
                return run(tries + 1, once, isFinal);
              } else if (isSilence(failure) && isTimeLeft.getAsBoolean()) {
                return CompletableFuture.supplyAsync(() -> run(tries + 1, once, isFinal), later())
                    .thenCompose(next -> next);
              }
              return CompletableFuture.failedFuture(failure);
            });
  }

  private static Executor later() {
    return CompletableFuture.delayedExecutor(BACKOFF.toMillis(), TimeUnit.MILLISECONDS);
  }

  private static boolean isSilence(Throwable failure) {
    Throwable cause = cause(failure);
    return cause instanceof TimeoutException || cause instanceof DeadlineExceededException;
  }

  /** The cause of a failed attempt, without the wrapping exceptions of futures. */
  static Throwable cause(Throwable failure) {
    Throwable cause = failure;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return cause;
  }
}
