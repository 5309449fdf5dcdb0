package org.dfra.core.time;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs tasks that timers submit, one after the other, on a separate daemon thread, which is started
 * on demand. So a task that blocks, for example in a driver, delays only the tasks behind it here,
 * and never a timer. In lock-step the tasks run on the scheduler.
 *
 * <p>If the thread cannot be started, since the computer has no more threads, the tasks wait, and
 * the start is retried twice a second.
 */
public final class SerialExecutor implements Executor, AutoCloseable {

  /** Delay between attempts to start the thread, nanoseconds of the scheduler's time. */
  static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  /** An idle thread begins a task within microseconds, unless the whole computer stalls. */
  private static final long STALL_MILLIS = 400;

  private static final Logger LOG = LoggerFactory.getLogger(SerialExecutor.class);

  private final String name;
  private final Scheduler scheduler;
  private final ThreadFactory threads;

  /** The thread that runs the tasks, once it has run one. */
  private volatile @Nullable Thread running;

  // until a thread can be started
  @GuardedBy("this")
  private final Queue<Runnable> waiting = new ArrayDeque<>();

  @GuardedBy("this")
  private @Nullable ThreadPoolExecutor thread;

  @GuardedBy("this")
  private boolean retrying;

  @GuardedBy("this")
  private boolean closed;

  /**
   * @param name name of the thread
   * @param scheduler the scheduler whose timers submit tasks
   */
  public SerialExecutor(String name, Scheduler scheduler) {
    this(name, scheduler, Thread::new);
  }

  /** For tests: with threads that can fail to start. */
  SerialExecutor(String name, Scheduler scheduler, ThreadFactory threads) {
    this.name = name;
    this.scheduler = scheduler;
    this.threads = threads;
  }

  /**
   * Starts the thread in advance, so that it cannot fail later, when the robot must be stopped.
   *
   * @throws OutOfMemoryError if no more threads can be created
   */
  public synchronized void prepare() {
    if (!closed && !scheduler.isLockStep()) {
      boolean unused = thread().prestartCoreThread();
    }
  }

  /** Starts the thread if there is none yet; false if no more threads can be created. */
  public boolean isPrepared() {
    try {
      prepare();
      return true;
    } catch (OutOfMemoryError e) {
      return false;
    }
  }

  /** Submits a task, unless this is closed. Never waits. */
  @Override
  public void execute(Runnable task) {
    synchronized (this) {
      if (closed) {
        return;
      }
      if (!scheduler.isLockStep()) {
        waiting.add(task);
        handOver();
        return;
      }
    }
    task.run();
  }

  /**
   * Submits a task, and waits for its end for a limited time: a longer task continues after this
   * call. If called by a task of this thread, it runs the new task at once, to its end.
   *
   * @param patience maximum time for the task, and for those before it, real time. If the computer
   *     stalls and does not schedule an idle thread, the wait is 0.4 s longer.
   * @return whether it has ended; what it threw by then is thrown here
   */
  public boolean executeWithin(Runnable task, Duration patience) {
    if (Thread.currentThread() == running) {
      task.run(); // no other thread would run it before this returns
      return true;
    }
    boolean isIdle = isIdle();
    Awaited awaited = new Awaited(task);
    execute(awaited);
    return awaited.await(patience.toMillis(), isIdle ? STALL_MILLIS : 0);
  }

  private synchronized boolean isIdle() {
    return waiting.isEmpty()
        && (thread == null || (thread.getActiveCount() == 0 && thread.getQueue().isEmpty()));
  }

  @GuardedBy("this")
  private void handOver() {
    try {
      for (Runnable task = waiting.peek(); task != null; task = waiting.peek()) {
        thread().execute(guarded(task));
        waiting.remove();
      }
    } catch (OutOfMemoryError e) {
      if (!retrying) {
        LOG.warn("{}: its thread cannot be started, which is tried again: {}", name, e.toString());
        retrying = true;
        Scheduler.ScheduledTask unused = scheduler.after(RETRY_NANOS, this::retry);
      }
    }
  }

  private synchronized void retry() {
    retrying = false;
    handOver();
    if (closed && waiting.isEmpty() && thread != null) {
      thread.shutdown();
    }
  }

  /** A thread that ends by a task's exception might not be replaced; so it does not end. */
  private Runnable guarded(Runnable task) {
    return () -> {
      running = Thread.currentThread();
      try {
        task.run();
      } catch (RuntimeException | Error e) {
        Thread here = Thread.currentThread();
        here.getUncaughtExceptionHandler().uncaughtException(here, e);
      }
    };
  }

  @GuardedBy("this")
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
                Thread fresh = threads.newThread(task);
                fresh.setName(name);
                fresh.setDaemon(true);
                return fresh;
              });
      thread = made;
    }
    return made;
  }

  /** Accepts no more tasks, and drops those that have not begun; the running one is interrupted. */
  public synchronized void closeNow() {
    closed = true;
    waiting.clear();
    if (thread != null) {
      thread.shutdownNow();
    }
  }

  /** Accepts no more tasks; those already submitted are run, and none is interrupted. */
  @Override
  public synchronized void close() {
    closed = true;
    if (waiting.isEmpty() && thread != null) {
      thread.shutdown();
    }
  }

  /** A task whose end is awaited for a limited time. */
  private static final class Awaited implements Runnable {

    private final Runnable task;
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch over = new CountDownLatch(1);

    @GuardedBy("this")
    private @Nullable Throwable failure;

    @GuardedBy("this")
    private boolean isAbandoned;

    Awaited(Runnable task) {
      this.task = task;
    }

    @Override
    public void run() {
      begun.countDown();
      try {
        task.run();
      } catch (RuntimeException | Error e) {
        synchronized (this) {
          if (isAbandoned) {
            throw e; // it would not be reported otherwise
          }
          failure = e;
        }
      } finally {
        over.countDown();
      }
    }

    /** Whether it has ended within {@code millis} after it began, or could not begin by then. */
    boolean await(long millis, long stallMillis) {
      boolean isOver = false;
      try {
        isOver =
            begun.await(millis + stallMillis, TimeUnit.MILLISECONDS)
                && over.await(millis, TimeUnit.MILLISECONDS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      synchronized (this) {
        isAbandoned = !isOver && over.getCount() > 0;
        if (failure instanceof RuntimeException exception) {
          throw exception;
        } else if (failure instanceof Error error) {
          throw error;
        }
        return !isAbandoned;
      }
    }
  }
}
