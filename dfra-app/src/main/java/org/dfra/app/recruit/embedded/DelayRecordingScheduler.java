package org.dfra.app.recruit.embedded;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.DoubleConsumer;
import org.dfra.core.time.ScaledTime;
import org.dfra.time.Scheduler;

/** A scheduler of scaled time that records the lateness of its tasks. */
final class DelayRecordingScheduler implements Scheduler {

  private final ScaledTime time;
  private volatile DoubleConsumer late = seconds -> {};

  DelayRecordingScheduler(ScaledTime time) {
    this.time = time;
  }

  /** Sets the listener for the lateness of each task, in real seconds. */
  void setDelayListener(DoubleConsumer listener) {
    late = listener;
  }

  @Override
  public long nanos() {
    return time.nanos();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    long due = time.nanos() + Math.max(0, nanos);
    return time.after(
        nanos,
        () -> {
          late.accept(Math.max(0, time.nanos() - due) / 1e9 / time.speed());
          MessageDelays.runTimed(task);
        });
  }

  @Override
  public Condition newCondition(ReentrantLock lock) {
    return time.newCondition(lock);
  }
}
