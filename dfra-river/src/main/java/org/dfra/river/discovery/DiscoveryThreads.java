package org.dfra.river.discovery;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.river.identity.CurrentIdentity;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The threads of one search: daemons with the context class loader of the thread that started it.
 *
 * @param isExhausted whether the last attempt to start a thread failed
 */
record DiscoveryThreads(
    ScheduledThreadPoolExecutor timer,
    ThreadPoolExecutor probes,
    ThreadPoolExecutor checks,
    AtomicBoolean isExhausted) {

  private static final Logger LOG = LoggerFactory.getLogger(DiscoveryThreads.class);

  /**
   * Maximum number of concurrent checks: with only one, a lookup service that stalls would block
   * all other checks. Checks that are due at the same time start in the order in which the lookup
   * services were found.
   */
  static final int CHECKS = DiscoveryCandidates.PROBES;

  private static final long IDLE_SECONDS = 10;

  static DiscoveryThreads begin() {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(1, named("dfra-discovery-timer"));
    timer.setRemoveOnCancelPolicy(true);
    boolean unused = timer.prestartCoreThread(); // retries tasks that found no thread
    return new DiscoveryThreads(
        timer,
        pool(DiscoveryCandidates.PROBES, named("dfra-discovery-probe")),
        pool(CHECKS, named("dfra-discovery-check")),
        new AtomicBoolean());
  }

  private static ThreadFactory named(String name) {
    AtomicInteger number = new AtomicInteger();
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    CurrentIdentity.Kept identity = CurrentIdentity.keep();
    return task -> {
      Thread thread = new Thread(identity.wrap(task), name + "-" + number.incrementAndGet());
      thread.setDaemon(true);
      thread.setContextClassLoader(loader);
      return thread;
    };
  }

  private static ThreadPoolExecutor pool(int threads, ThreadFactory factory) {
    ThreadPoolExecutor pool =
        new ThreadPoolExecutor(
            threads, threads, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), factory);
    pool.allowCoreThreadTimeOut(true);
    return pool;
  }

  /**
   * Runs a probe; false if no thread is available now, or the search is closed. Then the probe does
   * not run, and the caller retries later.
   */
  boolean probe(Runnable probe) {
    return run(probes, probe);
  }

  /** Runs a check; otherwise as {@link #probe}. */
  boolean check(Runnable check) {
    return run(checks, check);
  }

  private boolean run(ThreadPoolExecutor pool, Runnable task) {
    try {
      pool.execute(task);
      isExhausted.set(false);
      return true;
    } catch (RejectedExecutionException | OutOfMemoryError e) { // the latter: no native thread
      if (!isExhausted.getAndSet(true)) {
        LOG.warn("Lookup services cannot be asked now and are asked again: {}", e.toString());
      }
      return false;
    }
  }

  /** Starts nothing more, and interrupts waiting threads. */
  void end() {
    timer.shutdownNow();
    probes.shutdownNow();
    checks.shutdownNow();
  }
}
