package org.dfra.river.discovery;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The threads of one search: daemons, which load classes as the thread that began it does.
 *
 * @param isExhausted whether the last thread that was wanted could not be started
 */
record DiscoveryThreads(
    ScheduledThreadPoolExecutor timer,
    ThreadPoolExecutor probes,
    ThreadPoolExecutor checks,
    AtomicBoolean isExhausted) {

  private static final Logger LOG = LoggerFactory.getLogger(DiscoveryThreads.class);

  /**
   * Most checks at once: with one, a lookup service that stalls would keep all others from being
   * checked. Those that are due at the same time begin in the order in which the lookup services
   * were found: those known longest first.
   */
  static final int CHECKS = DiscoveryCandidates.PROBES;

  private static final long IDLE_SECONDS = 10;

  static DiscoveryThreads begin() {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(1, named("dfra-discovery-timer"));
    timer.setRemoveOnCancelPolicy(true);
    boolean unused = timer.prestartCoreThread(); // it begins again what found no thread
    return new DiscoveryThreads(
        timer,
        pool(DiscoveryCandidates.PROBES, named("dfra-discovery-probe")),
        pool(CHECKS, named("dfra-discovery-check")),
        new AtomicBoolean());
  }

  private static ThreadFactory named(String name) {
    AtomicInteger number = new AtomicInteger();
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    return task -> {
      Thread thread = new Thread(task, name + "-" + number.incrementAndGet());
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
   * Runs a probe; false if there is no thread for it now, or the search is over. Then it does not
   * run at all, and the caller tries again later.
   */
  boolean probe(Runnable probe) {
    return run(probes, probe);
  }

  /** Runs a check likewise. */
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

  /** Begins nothing more, and interrupts what waits. */
  void end() {
    timer.shutdownNow();
    probes.shutdownNow();
    checks.shutdownNow();
  }
}
