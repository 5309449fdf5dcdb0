package org.dfra.sim.time;

import org.dfra.sim.time.Agenda.Due;
import org.dfra.time.Scheduler.Task;
import org.jspecify.annotations.Nullable;

/** A task that is entered again, a period later, before it runs. */
final class Repetition implements Task {

  private final Agenda agenda;
  private final long period;
  private final Runnable task;
  private @Nullable Due next; // guarded by this
  private boolean cancelled; // guarded by this

  Repetition(Agenda agenda, long period, Runnable task) {
    this.agenda = agenda;
    this.period = period;
    this.task = task;
  }

  synchronized Repetition start() {
    next = agenda.add(agenda.in(period), task, this::run);
    return this;
  }

  private void run() {
    synchronized (this) {
      if (next == null || cancelled) {
        return;
      }
      next = agenda.again(next, agenda.in(period));
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
