package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Executes work in steps, one after the other, whenever it is woken or a step is due. It uses a
 * thread of a pool only while there is something to do. So a program may have hundreds of them.
 *
 * <p>Steps have the context class loader and the identity of the thread that made the worker. What
 * one step writes, the next one sees, also on another thread. Thread-safe.
 */
final class PooledWorker implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(PooledWorker.class);
  private static final long THREAD_RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

  /** What is done; never by two threads at a time. */
  interface Work {

    /**
     * Does what there is to do.
     *
     * @throws IOException if the work has failed for good
     */
    void step() throws IOException;

    /** The time until the next step, if nothing wakes before, nanoseconds. */
    long nanosUntilNext();

    /**
     * The last call, after the worker was closed or a step has failed.
     *
     * @param failure of the step; null if there was none
     */
    void end(@Nullable Exception failure);
  }

  private final Object name; // for people
  private final ThreadPoolExecutor threads;
  private final Work work;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();
  private final CurrentIdentity.Kept identity = CurrentIdentity.keep();

  /** The thread that works now. */
  @GuardedBy("this")
  private @Nullable Thread thread;

  /** Whether there is something to do once more. */
  @GuardedBy("this")
  private boolean isWoken;

  /** Whether a thread works, or will. */
  @GuardedBy("this")
  private boolean isStarted;

  @GuardedBy("this")
  private boolean isEnded;

  @GuardedBy("this")
  private @Nullable ScheduledTask next;

  private volatile boolean closed;

  /**
   * A worker that begins with its first {@link #wake}.
   *
   * @param name for people; its text is computed when it is needed
   */
  PooledWorker(Object name, ThreadPoolExecutor threads, Work work) {
    this.name = name;
    this.threads = threads;
    this.work = work;
  }

  /** Makes a thread take a step soon. Never waits. */
  void wake() {
    synchronized (this) {
      if (isEnded) {
        return;
      }
      isWoken = true;
      if (isStarted) {
        return;
      }
      isStarted = true;
    }
    try {
      threads.execute(identity.wrap(this::run));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("{} has no thread now; this is tried again: {}", name, e.toString());
      synchronized (this) {
        isStarted = false;
        next = Scheduler.system().after(THREAD_RETRY_NANOS, this::wake);
      }
    }
  }

  private void run() {
    synchronized (this) {
      thread = Thread.currentThread();
    }
    Thread.currentThread().setContextClassLoader(loader);
    boolean isOver = true; // also after an error
    @Nullable Exception failure = null;
    try {
      while (isWork() && !closed) {
        work.step();
      }
      isOver = closed;
    } catch (IOException | RuntimeException e) {
      failure = e;
    } finally {
      Thread.currentThread().setContextClassLoader(null);
      leave();
      if (isOver && isFirstEnd()) {
        work.end(failure);
      }
    }
  }

  /** Whether it was woken once more; otherwise the thread leaves, and the next step is timed. */
  private synchronized boolean isWork() {
    if (isWoken) {
      isWoken = false;
      return true;
    }
    isStarted = false;
    thread = null;
    if (next != null) {
      next.cancel();
    }
    next = Scheduler.system().after(work.nanosUntilNext(), this::wake);
    return false;
  }

  /** The thread does something else from now on, and is not to be interrupted. */
  private synchronized void leave() {
    if (thread == Thread.currentThread()) {
      thread = null;
    }
    boolean unused = Thread.interrupted(); // by close
  }

  private synchronized boolean isFirstEnd() {
    if (isEnded) {
      return false;
    }
    isEnded = true;
    if (next != null) {
      next.cancel();
    }
    return true;
  }

  boolean isClosed() {
    return closed;
  }

  /** Interrupts a running step, and ends the work without waiting for it. */
  @Override
  public void close() {
    closed = true;
    synchronized (this) {
      if (thread != null) {
        thread.interrupt();
      }
    }
    wake(); // to end
  }
}
