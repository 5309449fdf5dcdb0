package org.dfra.benchmarks;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.benchmarks.attack.ProcessSample;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Samples how many threads processes have, from its start until {@link #close}, and keeps the
 * maximum. One daemon thread.
 */
final class ThreadCounter implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ThreadCounter.class);

  /** How many threads there are now. */
  @FunctionalInterface
  interface Source {
    int count() throws IOException, InterruptedException;

    /** Those of processes, added up. */
    static Source of(List<Long> pids) {
      return () -> {
        int sum = 0;
        for (long pid : pids) {
          sum += ProcessSample.threads(pid);
        }
        return sum;
      };
    }
  }

  private final Source threads;
  private final ScheduledExecutorService sampler =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "dfra-bench-thread-counter");
            thread.setDaemon(true);
            return thread;
          });

  @GuardedBy("this")
  private int maximum;

  private ThreadCounter(Source threads) {
    this.threads = threads;
  }

  /**
   * Begins to sample.
   *
   * @param interval between two samples
   */
  static ThreadCounter start(Source threads, Duration interval) {
    ThreadCounter counter = new ThreadCounter(threads);
    var unused =
        counter.sampler.scheduleAtFixedRate(
            counter::trySample, 0, interval.toNanos(), TimeUnit.NANOSECONDS);
    return counter;
  }

  /**
   * Waits until the count has not changed for a while, as after a program's start.
   *
   * @param quiet how long it must not change
   * @param poll between two looks
   * @param patience how long to wait at most
   * @return false if it still changed then
   */
  static boolean awaitSettled(Source threads, Duration quiet, Duration poll, Duration patience)
      throws IOException, InterruptedException {
    long began = System.nanoTime();
    long since = began;
    int last = threads.count();
    while (System.nanoTime() - since < quiet.toNanos()) {
      if (System.nanoTime() - began > patience.toNanos()) {
        return false;
      }
      TimeUnit.NANOSECONDS.sleep(poll.toNanos());
      int now = threads.count();
      if (now != last) {
        last = now;
        since = System.nanoTime();
      }
    }
    return true;
  }

  private void trySample() {
    try {
      sample();
    } catch (IOException e) { // a process has ended, which its user finds out
      LOG.debug("Threads could not be counted.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // by close
    }
  }

  private void sample() throws IOException, InterruptedException {
    int now = threads.count();
    synchronized (this) {
      maximum = Math.max(maximum, now);
    }
  }

  /**
   * The largest count so far; the threads are counted once more for it.
   *
   * @throws IOException if they cannot be counted now
   */
  int maximum() throws IOException, InterruptedException {
    sample();
    synchronized (this) {
      return maximum;
    }
  }

  @Override
  public void close() {
    sampler.shutdownNow();
  }
}
