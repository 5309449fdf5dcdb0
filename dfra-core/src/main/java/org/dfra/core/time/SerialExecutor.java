package org.dfra.core.time;

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
 * Runs what timers hand over, one after the other, on a daemon thread of its own, which begins when
 * it is first needed. So a task that is held up, by a driver that blocks say, holds up nobody but
 * those behind it here, and never a timer. In lock-step the tasks are the timer's own.
 *
 * <p>Where the thread cannot be started, since the computer has none left, the tasks wait, and it
 * is tried again twice a second.
 */
public final class SerialExecutor implements Executor, AutoCloseable {

  /** From one try to start the thread to the next, nanoseconds of the scheduler's time. */
  static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  /** An idle thread begins a task within microseconds, unless the whole computer stalls. */
  private static final long STALL_MILLIS = 400;

  private static final Logger LOG = LoggerFactory.getLogger(SerialExecutor.class);

  private final String name;
  private final Scheduler scheduler;
  private final ThreadFactory threads;

  /** The one that runs the tasks, once it has run one. */
  private volatile @Nullable Thread running;

  // guarded by this
  private final Queue<Runnable> waiting = new ArrayDeque<>(); // for a thread that can be started
  private @Nullable ThreadPoolExecutor thread;
  private boolean retrying;
  private boolean closed;

  /**
   * @param name of the thread
   * @param scheduler whose timer hands over
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
   * Begins the thread, so that it cannot fail to later, when something has to be stopped.
   *
   * @throws OutOfMemoryError if there cannot be one more thread
   */
  public synchronized void prepare() {
    if (!closed && !scheduler.isLockStep()) {
      boolean unused = thread().prestartCoreThread();
    }
  }

  /** Begins the thread where there is none yet; false where there cannot be one more. */
  public boolean isPrepared() {
    try {
      prepare();
      return true;
    } catch (OutOfMemoryError e) {
      return false;
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
        waiting.add(task);
        handOver();
        return;
      }
    }
    task.run();
  }

  /**
   * Has a task run, and waits for its end, but not for long: it goes on after this call where it
   * takes longer. A task of this thread has it run at once, and waits for its end.
   *
   * @param patience how long it may take; also how long those before it may, real time. Where the
   *     computer stalls and does not begin an idle thread, that is waited for 0.4 s longer.
   * @return whether it has ended; what it threw by then is thrown here
   */
  public boolean executeWithin(Runnable task, Duration patience) {
    if (Thread.currentThread() == running) {
      task.run(); // nobody else would before this returns
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

  private void handOver() { // called with the lock held
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

  /** A thread that ends by a task's fault might not be replaced; so it does not end. */
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

  /** Takes no more tasks, and drops those that have not begun; the one that has is interrupted. */
  public synchronized void closeNow() {
    closed = true;
    waiting.clear();
    if (thread != null) {
      thread.shutdownNow();
    }
  }

  /** Takes no more tasks; those that it has are run, and none is interrupted. */
  @Override
  public synchronized void close() {
    closed = true;
    if (waiting.isEmpty() && thread != null) {
      thread.shutdown();
    }
  }

  /** A task whose end is awaited for a while. */
  private static final class Awaited implements Runnable {

    private final Runnable task;
    private final CountDownLatch begun = new CountDownLatch(1);
    private final CountDownLatch over = new CountDownLatch(1);
    private @Nullable Throwable failure; // guarded by this
    private boolean isAbandoned; // guarded by this

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
            throw e; // nobody else would hear of it
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
