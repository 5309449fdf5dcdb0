package org.dfra.app.stop;

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
 * How often a call is made that fails: twice, and again while there is time where nobody answered.
 * The computer that is called, or the operator's, may be so busy that an answer takes longer than
 * one try has.
 *
 * @param attemptTimeout for one try
 * @param isTimeLeft whether what has not answered twice is tried again
 */
record RetryPolicy(Duration attemptTimeout, BooleanSupplier isTimeLeft) {

  private static final int MIN_ATTEMPTS = 2;

  /**
   * From the second failure on: where many calls of a peer hang, the next ones fail at once, and
   * say that they were not answered.
   */
  static final Duration BACKOFF = Duration.ofMillis(500);

  /**
   * Makes a call, again and again.
   *
   * @param once begins one try, which ends by itself
   * @param isFinal whether a failure is one that no repetition changes
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

  /** What a try has failed with, without the exceptions that futures put around it. */
  static Throwable cause(Throwable failure) {
    Throwable cause = failure;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return cause;
  }
}
