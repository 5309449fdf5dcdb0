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

  private static final long IDLE_SECONDS = 10;

  static DiscoveryThreads begin() {
    ScheduledThreadPoolExecutor timer =
        new ScheduledThreadPoolExecutor(1, named("dfra-discovery-timer"));
    timer.setRemoveOnCancelPolicy(true);
    return new DiscoveryThreads(
        timer,
        pool(AnnouncedHosts.PROBES, named("dfra-discovery-probe")),
        pool(1, named("dfra-discovery-check")));
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
