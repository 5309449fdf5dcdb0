package org.dfra.core.chain;

import org.dfra.core.time.SerialExecutor;
import org.dfra.time.Scheduler;

/**
 * Runs delayed tasks that may block. In lock-step they are the scheduler's own tasks; otherwise
 * they run on a separate thread, which is started on demand.
 */
public final class DelayedTaskExecutor implements AutoCloseable {

  private final Scheduler scheduler;
  private final SerialExecutor thread;

  /**
   * @param name name of the thread
   * @param scheduler measures the delay
   */
  public DelayedTaskExecutor(String name, Scheduler scheduler) {
    this.scheduler = scheduler;
    this.thread = new SerialExecutor(name, scheduler);
  }

  /** Runs a task after a delay, unless this is closed before. */
  public void schedule(long nanos, Runnable task) {
    Scheduler.ScheduledTask unused = scheduler.after(nanos, () -> execute(task));
  }

  /** Runs a task after those submitted before. */
  public void execute(Runnable task) {
    thread.execute(task);
  }

  /** Runs no further tasks; the current one may still finish. */
  @Override
  public void close() {
    thread.closeNow();
  }
}
