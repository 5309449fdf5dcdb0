package org.dfra.cli.team;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;

/**
 * Sends the same query to several modules in parallel, so that an unresponsive one does not delay
 * the others.
 */
public final class ParallelQuery {

  private ParallelQuery() {}

  /** Creates the result for a failed query. */
  @FunctionalInterface
  public interface Fallback<A> {
    /**
     * @param cause an {@link ExecutionException} with the failure of the call, or a {@link
     *     TimeoutException} if it did not end in time
     */
    A of(Throwable cause);
  }

  /**
   * Runs the queries, each on a thread of its own.
   *
   * @param asked the queried objects
   * @param question queries one of them
   * @param failure creates the result of a failed query
   * @param deadline timeout for all answers together
   * @return the answers in the order of the queried objects
   */
  public static <M, A> List<A> ask(
      List<M> asked, Function<M, Callable<A>> question, Fallback<A> failure, Duration deadline)
      throws InterruptedException {
    ExecutorService askers =
        Executors.newCachedThreadPool(
            task -> {
              Thread thread = new Thread(task, "dfra-inquiry");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<Future<A>> answers = new ArrayList<>();
      for (M each : asked) {
        answers.add(askers.submit(question.apply(each)));
      }
      long end = System.nanoTime() + deadline.toNanos();
      List<A> all = new ArrayList<>();
      for (Future<A> each : answers) {
        all.add(answer(each, failure, end - System.nanoTime()));
      }
      return all;
    } finally {
      askers.shutdownNow();
    }
  }

  private static <A> A answer(Future<A> asked, Fallback<A> failure, long nanos)
      throws InterruptedException {
    try {
      return asked.get(Math.max(0, nanos), TimeUnit.NANOSECONDS);
    } catch (TimeoutException | ExecutionException e) {
      return failure.of(e);
    }
  }
}
