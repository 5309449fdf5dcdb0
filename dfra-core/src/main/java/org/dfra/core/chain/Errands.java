package org.dfra.core.chain;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Does things later that may take their time. In lock-step they are the scheduler's own tasks;
 * elsewhere a thread of its own does them, begun when it is first needed.
 */
public final class Errands implements AutoCloseable {

  private final String name;
  private final Scheduler scheduler;
  private @Nullable ExecutorService thread; // guarded by this
  private boolean closed; // guarded by this

  /**
   * @param name of the thread
   * @param scheduler counts the time until then
   */
  public Errands(String name, Scheduler scheduler) {
    this.name = name;
    this.scheduler = scheduler;
  }

  /** Does something after a while, unless this is closed before. */
  public void later(long nanos, Runnable task) {
    Scheduler.Task unused = scheduler.after(nanos, () -> now(task));
  }

  /** Does something as soon as what was asked for before is done. */
  public void now(Runnable task) {
    if (scheduler.isLockStep()) {
      synchronized (this) {
        if (closed) {
          return;
        }
      }
      task.run();
      return;
    }
    synchronized (this) {
      if (!closed) {
        thread().execute(task);
      }
    }
  }

  private ExecutorService thread() {
    ExecutorService made = thread;
    if (made == null) {
      made =
          Executors.newSingleThreadExecutor(
              task -> {
                Thread fresh = new Thread(task, name);
                fresh.setDaemon(true);
                return fresh;
              });
      thread = made;
    }
    return made;
  }

  /** Does nothing more; what is being done may still finish. */
  @Override
  public synchronized void close() {
    closed = true;
    if (thread != null) {
      thread.shutdownNow();
    }
  }
}
