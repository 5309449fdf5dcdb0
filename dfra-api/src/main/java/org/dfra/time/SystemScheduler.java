package org.dfra.time;

import java.lang.System.Logger.Level;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** The computer's monotonic time, and the two timer threads of this virtual machine. */
enum SystemScheduler implements Scheduler {
  INSTANCE("dfra-timer", Thread.NORM_PRIORITY),
  COMMANDS("dfra-command-timer", Thread.MAX_PRIORITY);

  private static final System.Logger LOG = System.getLogger(Scheduler.class.getName());

  private final ScheduledThreadPoolExecutor timer;

  SystemScheduler(String name, int priority) {
    timer =
        new ScheduledThreadPoolExecutor(
            1,
            task -> {
              Thread thread = new Thread(task, name);
              thread.setDaemon(true);
              thread.setPriority(priority);
              thread.setContextClassLoader(null); // it outlives the code that starts it
              return thread;
            });
    timer.setRemoveOnCancelPolicy(true);
  }

  @Override
  public Scheduler commandTimer() {
    return COMMANDS;
  }

  @Override
  public long nanos() {
    return System.nanoTime();
  }

  @Override
  public ScheduledTask after(long nanos, Runnable task) {
    Future<?> future = timer.schedule(() -> run(task), nanos, TimeUnit.NANOSECONDS);
    return () -> future.cancel(false);
  }

  private static void run(Runnable task) {
    try {
      task.run();
    } catch (RuntimeException | Error e) {
      LOG.log(Level.ERROR, "a task of the timer failed: " + e, e);
      throw e;
    }
  }
}
