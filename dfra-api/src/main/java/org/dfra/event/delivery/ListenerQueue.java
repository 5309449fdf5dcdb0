package org.dfra.event.delivery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.util.concurrent.Executor;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The queue of one listener, bounded by its {@link DeliveryPolicy}; at most one delivery is in
 * progress. Offering never blocks and allocates nothing. The queue submits its next delivery to the
 * pool when the previous one has ended, so the pool holds at most one of its tasks at a time.
 */
public final class ListenerQueue implements AutoCloseable {

  /** For a listener that is never removed, whatever it throws. */
  public static final int NEVER_GIVE_UP = Integer.MAX_VALUE;

  private static final System.Logger LOG = System.getLogger(ListenerQueue.class.getName());
  private static final double NANOS_PER_SECOND = 1e9;

  private final ModuleListener listener;
  private final DeliveryPolicy policy;
  private final int failuresAllowed;
  private final Runnable whenGivenUp;
  private final Executor pool;
  private final Scheduler scheduler;
  private final long period;

  /** The context class loader of the registration; also used for notifications. */
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();

  @GuardedBy("this")
  private final @Nullable Delivery[] ring;

  @GuardedBy("this")
  private int head;

  @GuardedBy("this")
  private int size;

  @GuardedBy("this")
  private long dropped;

  @GuardedBy("this")
  private boolean underWay;

  @GuardedBy("this")
  private boolean closed;

  @GuardedBy("this")
  private long earliest;

  @GuardedBy("this")
  private int failures;

  @GuardedBy("this")
  private @Nullable String lastFailure;

  /**
   * @param maxFailures the listener is removed after this many consecutive failures
   * @param onGivenUp run once when that happens, on a thread of the pool
   * @param pool makes the deliveries: a {@link DeliveryPool}, or an executor of {@link
   *     PeerExecutors}
   */
  public ListenerQueue(
      ModuleListener listener,
      DeliveryPolicy policy,
      int maxFailures,
      Runnable onGivenUp,
      Executor pool,
      Scheduler scheduler) {
    this.listener = listener;
    this.policy = policy;
    this.failuresAllowed = maxFailures;
    this.whenGivenUp = onGivenUp;
    this.pool = pool;
    this.scheduler = scheduler;
    this.period = (long) (NANOS_PER_SECOND / policy.maxRate());
    this.ring = new @Nullable Delivery[policy.queueDepth()];
    this.earliest = scheduler.nanos();
  }

  /** Queues a delivery if the listener receives its kind; drops the oldest if the queue is full. */
  public synchronized void offer(Delivery delivery) {
    if (closed || !policy.kinds().contains(delivery.kind())) {
      return;
    }
    if (size == ring.length) {
      @Nullable Delivery oldest = take();
      dropped += 1 + (oldest == null ? 0 : oldest.dropped());
    }
    ring[(head + size) % ring.length] = delivery;
    size++;
    if (!underWay) {
      underWay = true;
      schedule();
    }
  }

  /** Whether the listener still receives events. */
  public synchronized boolean isOpen() {
    return !closed;
  }

  /** Nothing is delivered afterwards, except what is being delivered now. */
  @Override
  public synchronized void close() {
    closed = true;
    while (size > 0) {
      take();
    }
  }

  @GuardedBy("this")
  private @Nullable Delivery take() {
    @Nullable Delivery first = ring[head];
    ring[head] = null;
    head = (head + 1) % ring.length;
    size--;
    return first;
  }

  @GuardedBy("this")
  private void schedule() {
    long wait = earliest - scheduler.nanos();
    if (period > 0 && wait > 0) {
      scheduler.after(wait, () -> pool.execute(this::deliverNext));
    } else {
      pool.execute(this::deliverNext);
    }
  }

  private void deliverNext() {
    Delivery next;
    synchronized (this) {
      @Nullable Delivery first = size == 0 ? null : take();
      if (first == null) { // closed meanwhile
        underWay = false;
        return;
      }
      next = first.afterDropping(dropped);
      dropped = 0;
      earliest = scheduler.nanos() + period;
    }
    boolean givenUp = !deliver(next);
    synchronized (this) {
      if (givenUp) {
        close();
      }
      underWay = size > 0;
      if (underWay) {
        schedule();
      }
    }
    if (givenUp) {
      whenGivenUp.run();
    }
  }

  /** Notifies the listener; false if it is to be removed. */
  private boolean deliver(Delivery delivery) {
    Thread thread = Thread.currentThread();
    @Nullable ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(loader);
    try {
      listener.notify(delivery);
      synchronized (this) {
        failures = 0;
        lastFailure = null;
      }
      return true;
    } catch (RemoteException | RuntimeException | Error e) {
      return failed(delivery, e);
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  private synchronized boolean failed(Delivery delivery, Throwable e) {
    dropped += 1 + delivery.dropped();
    failures++;
    String failure = e.toString();
    boolean givenUp =
        failuresAllowed != NEVER_GIVE_UP
            && (failures >= failuresAllowed || e instanceof NoSuchObjectException);
    if (closed) {
      return true;
    }
    if (givenUp) {
      LOG.log(
          Level.INFO,
          "{0}: a listener is given up after {1} failures: {2}",
          delivery.module(),
          failures,
          failure);
    } else if (!failure.equals(lastFailure)) {
      lastFailure = failure;
      LOG.log(Level.WARNING, delivery.module() + ": a listener failed: " + failure, e);
    }
    return !givenUp;
  }
}
