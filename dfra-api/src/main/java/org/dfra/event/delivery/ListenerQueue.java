package org.dfra.event.delivery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.ServerException;
import java.rmi.UnmarshalException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The queue of one listener, bounded by its {@link DeliveryPolicy}; at most one call to the
 * listener is in progress. Offering never blocks and allocates nothing. The queue submits its next
 * call to the pool when the previous one has ended, so the pool holds at most one of its tasks at a
 * time.
 *
 * <p>A {@link BatchListener} gets all events that wait, within its {@link BatchLimits}, in one
 * call. If its policy limits the rate of deliveries, it gets one event in each call.
 */
public final class ListenerQueue implements AutoCloseable {

  /** For a listener that is never removed, whatever it throws. */
  public static final int NEVER_GIVE_UP = Integer.MAX_VALUE;

  private static final System.Logger LOG = System.getLogger(ListenerQueue.class.getName());
  private static final double NANOS_PER_SECOND = 1e9;

  private final BatchListener listener;
  private final DeliveryPolicy policy;
  private final BatchLimits limits;
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

  /** The most events of the next call: fewer after a slow or failed one. */
  @GuardedBy("this")
  private int most;

  /**
   * For a listener that is notified of one event at a time.
   *
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
    this(
        (BatchListener) deliveries -> listener.notify(deliveries.get(0)),
        BatchLimits.ONE,
        policy,
        maxFailures,
        onGivenUp,
        pool,
        scheduler);
  }

  /**
   * For a listener that is notified of several events at once. A call that throws counts as one
   * failure, and all its events as dropped.
   *
   * @param limits of the events in one call
   * @param maxFailures the listener is removed after this many consecutive failures
   * @param onGivenUp run once when that happens, on a thread of the pool
   * @param pool makes the calls, as in the other constructor
   */
  public ListenerQueue(
      BatchListener listener,
      BatchLimits limits,
      DeliveryPolicy policy,
      int maxFailures,
      Runnable onGivenUp,
      Executor pool,
      Scheduler scheduler) {
    this.listener = listener;
    this.limits = limits;
    this.policy = policy;
    this.failuresAllowed = maxFailures;
    this.whenGivenUp = onGivenUp;
    this.pool = pool;
    this.scheduler = scheduler;
    this.period = (long) (NANOS_PER_SECOND / policy.maxRate());
    this.ring = new @Nullable Delivery[policy.queueDepth()];
    this.most = period > 0 ? 1 : limits.events();
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
    List<Delivery> next;
    long begun;
    synchronized (this) {
      next = takeBatch();
      if (next.isEmpty()) { // closed meanwhile
        underWay = false;
        return;
      }
      begun = scheduler.nanos();
      earliest = begun + period;
    }
    boolean givenUp = !deliver(next, begun);
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

  /** Takes the events of the next call; none if the queue is empty. */
  @GuardedBy("this")
  private List<Delivery> takeBatch() {
    @Nullable Delivery first = size == 0 ? null : take();
    if (first == null) {
      return List.of();
    }
    first = first.afterDropping(dropped);
    dropped = 0;
    if (size == 0 || most == 1) {
      return List.of(first);
    }
    List<Delivery> batch = new ArrayList<>(Math.min(most, size + 1));
    batch.add(first);
    long left = limits.bytes() - EventSize.of(first.event());
    while (size > 0 && batch.size() < most) {
      @Nullable Delivery next = ring[head];
      long bytes = next == null ? EventSize.UNKNOWN : EventSize.of(next.event());
      if (next == null || bytes > left) {
        break;
      }
      left -= bytes;
      batch.add(next);
      @Nullable Delivery unused = take();
    }
    return List.copyOf(batch);
  }

  /** Notifies the listener; false if it is to be removed. */
  private boolean deliver(List<Delivery> deliveries, long begun) {
    Thread thread = Thread.currentThread();
    @Nullable ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(loader);
    try {
      listener.notify(deliveries);
      delivered(deliveries.size(), scheduler.nanos() - begun);
      return true;
    } catch (RemoteException | RuntimeException | Error e) {
      return deliveries.size() > 1 && isUnread(e)
          ? deliverSingly(deliveries)
          : failed(deliveries, e);
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  /** Whether the listener could not read the call, so that it has got none of the events. */
  private static boolean isUnread(Throwable e) {
    return e instanceof ServerException && e.getCause() instanceof UnmarshalException;
  }

  /** One unreadable event costs no other one. */
  private boolean deliverSingly(List<Delivery> deliveries) {
    for (Delivery each : deliveries) {
      if (!deliver(List.of(each), scheduler.nanos())) {
        return false;
      }
    }
    return true;
  }

  private synchronized void delivered(int count, long nanos) {
    failures = 0;
    lastFailure = null;
    if (period == 0) {
      most =
          nanos > limits.slow().toNanos()
              ? Math.max(1, count / 2)
              : (int) Math.min(limits.events(), 2L * most);
    }
  }

  private synchronized boolean failed(List<Delivery> deliveries, Throwable e) {
    for (Delivery each : deliveries) {
      dropped += 1 + each.dropped();
    }
    most = 1;
    failures++;
    String failure = e.toString();
    boolean givenUp =
        failuresAllowed != NEVER_GIVE_UP
            && (failures >= failuresAllowed || e instanceof NoSuchObjectException);
    if (closed) {
      return true;
    }
    String module = deliveries.get(0).module();
    if (givenUp) {
      LOG.log(
          Level.INFO,
          "{0}: a listener is given up after {1} failures: {2}",
          module,
          failures,
          failure);
    } else if (!failure.equals(lastFailure)) {
      lastFailure = failure;
      LOG.log(Level.WARNING, module + ": a listener failed: " + failure, e);
    }
    return !givenUp;
  }
}
