package org.dfra.core.time;

import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Runs what timers hand over, one after the other, on a daemon thread of its own, which begins when
 * it is first needed. So a task that is held up, by a driver that blocks say, holds up nobody but
 * those behind it here, and never a timer. In lock-step the tasks are the timer's own.
 */
public final class SerialExecutor implements Executor, AutoCloseable {

  private final String name;
  private final Scheduler scheduler;
  private @Nullable ThreadPoolExecutor thread; // guarded by this
  private boolean closed; // guarded by this

  /**
   * @param name of the thread
   * @param scheduler whose timer hands over
   */
  public SerialExecutor(String name, Scheduler scheduler) {
    this.name = name;
    this.scheduler = scheduler;
  }

  /**
   * Begins the thread, so that it cannot fail to later, when something has to be stopped.
   *
   * @throws OutOfMemoryError if there cannot be one more thread
   */
  public synchronized void prepare() {
    if (!closed && !scheduler.isLockStep()) {
      boolean unused = thread().prestartCoreThread();
    }
  }

  /** Has a task run, unless this is closed. Never waits. */
  @Override
  public void execute(Runnable task) {
    synchronized (this) {
      if (closed) {
        return;
      }
      if (!scheduler.isLockStep()) {
        thread().execute(task);
        return;
      }
    }
    task.run();
  }

  private ThreadPoolExecutor thread() {
    ThreadPoolExecutor made = thread;
    if (made == null) {
      made =
          new ThreadPoolExecutor(
              1,
              1,
              0,
              TimeUnit.SECONDS,
              new LinkedBlockingQueue<>(),
              task -> {
                Thread fresh = new Thread(task, name);
                fresh.setDaemon(true);
                return fresh;
              });
      thread = made;
    }
    return made;
  }

  /** Takes no more tasks, and drops those that have not begun; the one that has is interrupted. */
  public synchronized void closeNow() {
    closed = true;
    if (thread != null) {
      thread.shutdownNow();
    }
  }

  /** Takes no more tasks; those that it has are run, and none is interrupted. */
  @Override
  public synchronized void close() {
    closed = true;
    if (thread != null) {
      thread.shutdown();
    }
  }
}
