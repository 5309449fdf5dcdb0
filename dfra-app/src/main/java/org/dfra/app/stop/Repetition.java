package org.dfra.app.stop;

import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.dfra.river.call.DeadlineExceededException;

/**
 * How often a call is made that fails: twice, and again while there is time where nobody answered.
 * The computer of an effector, or the operator's, may be so busy that an answer takes longer than
 * one try has.
 *
 * @param each for one try
 * @param isTimeLeft whether what has not answered twice is tried again
 */
record Repetition(Duration each, BooleanSupplier isTimeLeft) {

  private static final int TRIES = 2;

  /**
   * Makes a call, again and again.
   *
   * @param once begins one try, which ends by itself
   * @param isFinal whether a failure is one that no repetition changes
   * @return the first answer, or the last failure
   */
  <T> CompletableFuture<T> of(Supplier<CompletableFuture<T>> once, Predicate<Throwable> isFinal) {
    return of(1, once, isFinal);
  }

  private <T> CompletableFuture<T> of(
      int tries, Supplier<CompletableFuture<T>> once, Predicate<Throwable> isFinal) {
    return once.get()
        .exceptionallyCompose(
            failure ->
                !isFinal.test(failure)
                        && (tries < TRIES || (isSilence(failure) && isTimeLeft.getAsBoolean()))
                    ? of(tries + 1, once, isFinal)
                    : CompletableFuture.failedFuture(failure));
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
