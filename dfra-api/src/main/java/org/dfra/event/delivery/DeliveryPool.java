package org.dfra.event.delivery;

import java.lang.System.Logger.Level;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The threads that notify listeners.
 *
 * <p>A few core threads serve all listeners. A thread that has been in the same listener for more
 * than {@value #BLOCKED_MILLIS} ms counts as blocked. While tasks wait, another thread replaces it,
 * and ends when the blocked one returns. So there are as many threads as core threads plus blocked
 * ones, but never more than {@value #MAX_THREADS}: beyond them tasks wait for the first free
 * thread. Remote peers, which may not answer, share a part of the threads through {@link
 * PeerExecutors}. The threads are daemons, named {@code dfra-events-n}; idle ones end after ten
 * seconds.
 */
public final class DeliveryPool implements Executor {

  /** The largest number of threads of a pool. */
  public static final int MAX_THREADS = 64;

  private static final System.Logger LOG = System.getLogger(DeliveryPool.class.getName());
  private static final long BLOCKED_MILLIS = 2;
  private static final long BLOCKED_NANOS = TimeUnit.MILLISECONDS.toNanos(BLOCKED_MILLIS);
  private static final long IDLE_SECONDS = 10;

  private static final DeliveryPool SHARED =
      new DeliveryPool(
          Math.max(2, Math.min(4, Runtime.getRuntime().availableProcessors())), Scheduler.system());

  /** Delay before the next attempt to start a thread after one has failed. */
  private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

  private final int few;
  private final int most;
  private final Scheduler scheduler;
  private final Consumer<Thread> starter;
  private final LinkedBlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Set<Worker> workers = ConcurrentHashMap.newKeySet();
  private final AtomicInteger names = new AtomicInteger();
  private final AtomicInteger idle = new AtomicInteger(); // threads that wait for a task
  private final AtomicBoolean looking = new AtomicBoolean();

  /**
   * @param coreThreads how many threads serve while none is blocked, at least 1
   * @param scheduler the clock by which a thread counts as blocked
   */
  public DeliveryPool(int coreThreads, Scheduler scheduler) {
    this(coreThreads, MAX_THREADS, scheduler, Thread::start);
  }

  /**
   * The same with another way to start threads.
   *
   * @param maxThreads the largest number of threads, blocked ones included; not below {@code
   *     coreThreads}
   * @param starter starts a thread, or throws what {@link Thread#start} throws
   */
  DeliveryPool(int coreThreads, int maxThreads, Scheduler scheduler, Consumer<Thread> starter) {
    this.few = coreThreads;
    this.most = maxThreads;
    this.scheduler = scheduler;
    this.starter = starter;
  }

  /** The pool of this virtual machine. */
  public static DeliveryPool shared() {
    return SHARED;
  }

  /**
   * The pool for events of modules that use this scheduler: that of this virtual machine, or, in
   * lock-step, one without threads, in which the scheduler notifies listeners at the instant of the
   * event. There a blocking listener blocks everything.
   */
  public static DeliveryPool forScheduler(Scheduler scheduler) {
    return scheduler.isLockStep() ? new DeliveryPool(0, scheduler) : SHARED;
  }

  /** Runs a delivery soon; returns at once. It drops none. */
  @Override
  public void execute(Runnable task) {
    if (scheduler.isLockStep()) {
      scheduler.after(0, task);
      return;
    }
    tasks.add(task);
    serveAll();
  }

  /** How many threads there are. */
  public int threadCount() {
    return workers.size();
  }

  private void look() {
    looking.set(false);
    serveAll();
  }

  /** Starts threads for waiting tasks now, or schedules another attempt. Never throws. */
  private void serveAll() {
    boolean started = replaceBlocked();
    // Idle threads take as many tasks at once. If the maximum number of threads is reached, the
    // first free thread takes the next task.
    if (tasks.size() > idle.get() && workers.size() < most && looking.compareAndSet(false, true)) {
      try {
        scheduler.after(started ? BLOCKED_NANOS : RETRY_NANOS, this::look);
      } catch (OutOfMemoryError e) { // the timer has no thread either; the next task tries again
        looking.set(false);
        LOG.log(Level.WARNING, "deliveries wait for a thread: " + e);
      }
    }
  }

  /** Starts a thread if too few serve; false if none could be started. */
  private boolean replaceBlocked() {
    if (tasks.isEmpty() || suffices()) {
      return true;
    }
    synchronized (workers) {
      return suffices() || startOne();
    }
  }

  /** Whether no further thread is needed, or none may be started. */
  private boolean suffices() {
    return workers.size() >= most || atWork() >= few;
  }

  private boolean startOne() {
    Worker worker = new Worker();
    workers.add(worker); // before it runs, since it takes itself out
    try {
      starter.accept(worker);
      return true;
    } catch (OutOfMemoryError e) { // no memory for another thread; others serve, or a later one
      workers.remove(worker);
      LOG.log(Level.WARNING, "deliveries wait for a thread, which is tried again: " + e);
      return false;
    }
  }

  /** The number of threads that are not blocked. */
  private int atWork() {
    long now = scheduler.nanos();
    int count = 0;
    for (Worker worker : workers) {
      if (!worker.isBlocked(now)) {
        count++;
      }
    }
    return count;
  }

  /** One thread; it ends by itself. */
  private final class Worker extends Thread {

    private volatile boolean busy;
    private volatile long since;

    Worker() {
      super("dfra-events-" + names.incrementAndGet());
      setDaemon(true);
      setContextClassLoader(null);
    }

    boolean isBlocked(long now) {
      return busy && now - since > BLOCKED_NANOS;
    }

    @Override
    public void run() {
      try {
        while (mayStay()) {
          @Nullable Runnable turn = awaitTask();
          if (turn == null) {
            break;
          }
          if (!tasks.isEmpty()) { // it came when this thread still counted as idle
            serveAll();
          }
          serve(turn);
        }
      } catch (InterruptedException e) {
        LOG.log(Level.WARNING, "{0} was interrupted and ends", getName());
      } finally {
        workers.remove(this);
        serveAll(); // a task may have arrived while this one was ending
      }
    }

    private @Nullable Runnable awaitTask() throws InterruptedException {
      idle.incrementAndGet();
      try {
        return tasks.poll(IDLE_SECONDS, TimeUnit.SECONDS);
      } finally {
        idle.decrementAndGet();
      }
    }

    private void serve(Runnable turn) {
      since = scheduler.nanos();
      busy = true;
      try {
        turn.run();
      } catch (RuntimeException | Error e) {
        LOG.log(Level.ERROR, "a delivery failed in the delivery itself: " + e, e);
      } finally {
        busy = false;
      }
    }

    private boolean mayStay() {
      synchronized (workers) {
        if (atWork() > few) {
          workers.remove(this);
          return false;
        }
        return true;
      }
    }
  }
}
