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
 * The threads on which listeners are told.
 *
 * <p>A few threads serve all listeners in turn. One that has been in the same listener for more
 * than {@value #BLOCKED_MILLIS} ms counts as blocked, and while others wait another thread takes
 * its place; it ends when the blocked one is back. So there are as many threads as a few plus the
 * listeners that block, but never more than {@value #MAX_THREADS}: past them what is submitted
 * waits for the first thread that comes back. Peers elsewhere, which may not answer, share a part
 * of them by {@link PeerExecutors}. The threads are daemons, called {@code dfra-events-n}; those
 * without work end after ten seconds.
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

  /** How long to wait before a thread is asked for again where none could be started. */
  private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

  private final int few;
  private final int most;
  private final Scheduler scheduler;
  private final Consumer<Thread> starter;
  private final LinkedBlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final Set<Worker> workers = ConcurrentHashMap.newKeySet();
  private final AtomicInteger names = new AtomicInteger();
  private final AtomicBoolean looking = new AtomicBoolean();

  /**
   * @param coreThreads how many threads serve while none is blocked, at least 1
   * @param scheduler the time by which a thread counts as blocked
   */
  public DeliveryPool(int coreThreads, Scheduler scheduler) {
    this(coreThreads, MAX_THREADS, scheduler, Thread::start);
  }

  /**
   * The same, where threads are started in another way.
   *
   * @param maxThreads the largest number of threads, blocked ones included; not below {@code few}
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
   * The pool for events of modules that live by this time: that of this virtual machine; in
   * lock-step one without threads, whose listeners are told by the scheduler, at the instant of the
   * event. There a listener that blocks holds up everything.
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

  /** Sees to it that what waits is served: now, or else looks again soon. Never throws. */
  private void serveAll() {
    boolean started = replaceBlocked();
    // Where there are as many threads as there may be, the first that is free goes on by itself.
    if (!tasks.isEmpty() && workers.size() < most && looking.compareAndSet(false, true)) {
      try {
        scheduler.after(started ? BLOCKED_NANOS : RETRY_NANOS, this::look);
      } catch (OutOfMemoryError e) { // the timer has no thread either; the next turn tries again
        looking.set(false);
        LOG.log(Level.WARNING, "deliveries wait for a thread: " + e);
      }
    }
  }

  /** Has a thread serve where too few do; false where none could be started. */
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
    } catch (OutOfMemoryError e) { // no room for one more thread; others serve, or a later one
      workers.remove(worker);
      LOG.log(Level.WARNING, "deliveries wait for a thread, which is tried again: " + e);
      return false;
    }
  }

  /** Threads that are not blocked. */
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
          @Nullable Runnable turn = tasks.poll(IDLE_SECONDS, TimeUnit.SECONDS);
          if (turn == null) {
            break;
          }
          serve(turn);
        }
      } catch (InterruptedException e) {
        LOG.log(Level.WARNING, "{0} was interrupted and ends", getName());
      } finally {
        workers.remove(this);
        serveAll(); // a turn may have come while this one was ending
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
