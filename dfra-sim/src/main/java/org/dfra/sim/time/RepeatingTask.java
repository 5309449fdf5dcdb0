package org.dfra.sim.time;

import org.dfra.sim.time.EventQueue.ScheduledEvent;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/** A task that is scheduled again, a period later, before it runs. */
final class RepeatingTask implements ScheduledTask {

  private final EventQueue agenda;
  private final long period;
  private final Runnable task;
  private @Nullable ScheduledEvent next; // guarded by this
  private boolean cancelled; // guarded by this

  RepeatingTask(EventQueue agenda, long period, Runnable task) {
    this.agenda = agenda;
    this.period = period;
    this.task = task;
  }

  synchronized RepeatingTask start() {
    next = agenda.add(agenda.timeAfter(period), task, this::run);
    return this;
  }

  private void run() {
    synchronized (this) {
      if (next == null || cancelled) {
        return;
      }
      next = agenda.reschedule(next, agenda.timeAfter(period));
    }
    task.run();
  }

  @Override
  public synchronized void cancel() {
    cancelled = true;
    if (next != null) {
      agenda.remove(next);
    }
  }
}
