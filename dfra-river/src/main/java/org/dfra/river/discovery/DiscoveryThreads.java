package org.dfra.river.discovery;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** The threads of one search: daemons, which load classes as the thread that began it does. */
record DiscoveryThreads(
    ScheduledThreadPoolExecutor timer, ThreadPoolExecutor probes, ThreadPoolExecutor checks) {

  /**
   * Most checks at once: with one, a lookup service that stalls would keep all others from being
   * checked. Those that are due at the same time begin in the order in which the lookup services
   * were found: those known longest first.
   */
  static final int CHECKS = AnnouncedHosts.PROBES;

  private static final long IDLE_SECONDS = 10;

  static DiscoveryThreads begin() {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(1, named("dfra-discovery-timer"));
    timer.setRemoveOnCancelPolicy(true);
    return new DiscoveryThreads(
        timer,
        pool(AnnouncedHosts.PROBES, named("dfra-discovery-probe")),
        pool(CHECKS, named("dfra-discovery-check")));
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

  /** Begins nothing more, and interrupts what waits. */
  void end() {
    timer.shutdownNow();
    probes.shutdownNow();
    checks.shutdownNow();
  }
}
