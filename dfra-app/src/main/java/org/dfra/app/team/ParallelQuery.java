package org.dfra.app.team;

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

/** Asks several modules the same question at once, so that a silent one holds up no other. */
public final class ParallelQuery {

  private ParallelQuery() {}

  /** What counts as the answer of one that gave none. */
  @FunctionalInterface
  public interface Fallback<A> {
    /**
     * @param cause an {@link ExecutionException} by what the call failed with, or a {@link
     *     TimeoutException} where it did not end in time
     */
    A of(Throwable cause);
  }

  /**
   * Asks, each on a thread of its own.
   *
   * @param asked who is asked
   * @param question asks one of them
   * @param failure what counts as the answer of one that gave none
   * @param deadline how long the answers are awaited, all together
   * @return the answers in the order of those asked
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
