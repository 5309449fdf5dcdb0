package org.dfra.core.chain;

import org.dfra.core.time.SerialExecutor;
import org.dfra.time.Scheduler;

/**
 * Does things later that may take their time. In lock-step they are the scheduler's own tasks;
 * elsewhere a thread of its own does them, begun when it is first needed.
 */
public final class DelayedTaskExecutor implements AutoCloseable {

  private final Scheduler scheduler;
  private final SerialExecutor thread;

  /**
   * @param name of the thread
   * @param scheduler counts the time until then
   */
  public DelayedTaskExecutor(String name, Scheduler scheduler) {
    this.scheduler = scheduler;
    this.thread = new SerialExecutor(name, scheduler);
  }

  /** Does something after a while, unless this is closed before. */
  public void schedule(long nanos, Runnable task) {
    Scheduler.ScheduledTask unused = scheduler.after(nanos, () -> execute(task));
  }

  /** Does something as soon as what was asked for before is done. */
  public void execute(Runnable task) {
    thread.execute(task);
  }

  /** Does nothing more; what is being done may still finish. */
  @Override
  public void close() {
    thread.closeNow();
  }
}
