package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.constants.ThrowableConstants;
import java.lang.reflect.Field;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseException;
import net.jini.core.lease.LeaseMap;
import net.jini.core.lease.LeaseMapException;
import org.dfra.river.call.CallThreads;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Renews the leases of all registrations of this virtual machine. Those at one lookup service are
 * renewed in one call, so that the number of calls does not grow with the number of modules.
 *
 * <p>Here a lease is a span of monotonic time that begins with its grant. It is renewed after a
 * third of the span, together with the others there that are due within the next sixth.
 *
 * <p>Threads: daemons, {@code dfra-registration-n}, exist during calls, so a lookup service that
 * does not answer delays no renewal at another one.
 */
final class LeaseBatches {

  private static final Logger LOG = LoggerFactory.getLogger(LeaseBatches.class);

  /** Those of this virtual machine, in real time. */
  static final LeaseBatches SHARED = new LeaseBatches(Scheduler.system());

  /** The largest number of leases in one call. */
  static final int MOST = 128;

  /** The longest delay before a failed renewal is repeated. */
  private static final long LONGEST_WAIT = LookupTimings.MAX_RETRY_DELAY.toNanos();

  private static final long SHORTEST_WAIT = TimeUnit.MILLISECONDS.toNanos(50);

  private static final ThreadPoolExecutor CALLERS = CallThreads.pool("dfra-registration-");

  private final Scheduler time;

  @GuardedBy("this")
  private final Set<RenewedLease> all = new LinkedHashSet<>();

  LeaseBatches(Scheduler time) {
    this.time = time;
  }

  /** A lease that is renewed. The batches guard its mutable fields. */
  static final class RenewedLease {

    private final Lease lease;
    private final long millis;
    private final Consumer<Exception> givenUp;

    /** What renews it: only leases of the same server are renewed together. */
    private final @Nullable Object server;

    private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();
    private long end; // nanoseconds of the scheduler, like the next field
    private long due;
    private boolean isBeingRenewed;
    private @Nullable ScheduledTask next;

    private RenewedLease(Lease lease, long millis, Consumer<Exception> givenUp) {
      this.lease = lease;
      this.millis = millis;
      this.givenUp = givenUp;
      this.server = server(lease);
    }
  }

  /**
   * The remote reference of a lease of reggie; null for any other, which is renewed alone. Reggie's
   * leases say that they can be batched if the service IDs of their lookup services are equal. Any
   * lookup service may claim the ID of another one: then it would get the other's leases, and could
   * confirm what it does not renew.
   */
  private static @Nullable Object server(Lease lease) {
    for (Class<?> type = lease.getClass(); type != null; type = type.getSuperclass()) {
      try {
        Field field = type.getDeclaredField("server");
        field.setAccessible(true);
        return field.get(lease);
      } catch (NoSuchFieldException e) {
        continue; // perhaps its superclass has it
      } catch (IllegalAccessException | RuntimeException e) {
        LOG.debug("A lease is renewed alone, since its server is unknown.", e);
        return null;
      }
    }
    return null;
  }

  /**
   * Renews a lease from now on.
   *
   * @param lease granted just now
   * @param millis the duration to request, milliseconds
   * @param givenUp receives the reason when the lease is not renewed any more, on another thread
   */
  synchronized RenewedLease add(Lease lease, long millis, Consumer<Exception> givenUp) {
    RenewedLease added = new RenewedLease(lease, millis, givenUp);
    all.add(added);
    extend(added, time.nanos());
    return added;
  }

  /** Renews a lease no more. Does nothing if it is not renewed. */
  synchronized void remove(RenewedLease lease) {
    if (all.remove(lease) && lease.next != null) {
      lease.next.cancel();
    }
  }

  /** Records that a lease was granted or renewed, no earlier than {@code begun}. */
  @GuardedBy("this")
  private void extend(RenewedLease renewed, long begun) {
    long granted = renewed.lease.getExpiration() - System.currentTimeMillis();
    // A simultaneous change of the clock makes it look longer or expired. Both are harmless.
    long nanos = TimeUnit.MILLISECONDS.toNanos(Math.min(granted, renewed.millis));
    renewed.end = begun + nanos;
    after(nanos / 3, renewed);
  }

  @GuardedBy("this")
  private void after(long nanos, RenewedLease renewed) {
    long wait = Math.max(SHORTEST_WAIT, nanos);
    renewed.isBeingRenewed = false;
    renewed.due = time.nanos() + wait;
    renewed.next = time.after(wait, () -> send(renewed));
  }

  private void send(RenewedLease first) {
    List<RenewedLease> batch;
    synchronized (this) {
      if (first.isBeingRenewed || !all.contains(first)) {
        return; // with another batch, or removed meanwhile
      }
      batch = batch(first);
    }
    try {
      CALLERS.execute(() -> renew(batch));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("Registrations cannot be renewed now and are tried again: {}", e.toString());
      synchronized (this) {
        batch.forEach(each -> after(LONGEST_WAIT, each));
      }
    }
  }

  /** The leases to renew with the first one, which is due. */
  @GuardedBy("this")
  private List<RenewedLease> batch(RenewedLease first) {
    long latest = time.nanos() + TimeUnit.MILLISECONDS.toNanos(first.millis) / 6;
    List<RenewedLease> batch = new ArrayList<>(List.of(first));
    for (RenewedLease each : all) {
      if (batch.size() < MOST
          && each != first
          && !each.isBeingRenewed
          && each.due <= latest
          && Objects.equals(each.loader, first.loader)
          && canBatch(first, each)) {
        batch.add(each);
      }
    }
    for (RenewedLease each : batch) {
      each.isBeingRenewed = true;
      if (each.next != null) {
        each.next.cancel();
      }
    }
    return batch;
  }

  /** As a lookup service's own code says, which is not to disturb the others. */
  private static boolean canBatch(RenewedLease one, RenewedLease other) {
    try {
      return one.server != null
          && one.server.equals(other.server)
          && one.lease.canBatch(other.lease);
    } catch (RuntimeException | LinkageError e) {
      LOG.debug("A lease cannot be compared with another one; both are renewed alone.", e);
      return false;
    }
  }

  private void renew(List<RenewedLease> batch) {
    Thread.currentThread().setContextClassLoader(batch.get(0).loader);
    try {
      if (batch.size() == 1) {
        renewOne(batch.get(0));
      } else {
        renewTogether(batch);
      }
    } catch (Error e) { // a lookup service's code cannot be executed, or there is no memory
      LOG.warn("Registrations could not be renewed and are tried again: {}", e.toString(), e);
    } finally {
      Thread.currentThread().setContextClassLoader(null);
      repeatUnfinished(batch);
    }
  }

  /** If something unexpected ended the call, the leases that it has not concluded are due again. */
  private synchronized void repeatUnfinished(List<RenewedLease> batch) {
    for (RenewedLease each : batch) {
      if (each.isBeingRenewed && all.contains(each)) {
        after(LONGEST_WAIT, each);
      }
    }
  }

  private void renewOne(RenewedLease renewed) {
    long begun = time.nanos();
    try {
      renewed.lease.renew(renewed.millis);
      succeeded(renewed, begun);
    } catch (LeaseException | RemoteException | RuntimeException e) {
      failed(renewed, e);
    }
  }

  @SuppressWarnings("unchecked") // River's maps have no types
  private void renewTogether(List<RenewedLease> batch) {
    Map<Lease, RenewedLease> left = new IdentityHashMap<>(); // that have not failed
    batch.forEach(each -> left.put(each.lease, each));
    long begun = time.nanos();
    try {
      LeaseMap map = batch.get(0).lease.createLeaseMap(batch.get(0).millis);
      batch.forEach(each -> map.put(each.lease, each.millis));
      map.renewAll();
    } catch (LeaseMapException e) {
      ((Map<Lease, Throwable>) e.exceptionMap)
          .forEach(
              (lease, reason) -> {
                RenewedLease renewed = left.remove(lease);
                if (renewed != null) {
                  failed(renewed, asException(reason));
                }
              });
    } catch (RemoteException | RuntimeException e) {
      left.values().forEach(each -> failed(each, e));
      return;
    }
    left.values().forEach(each -> succeeded(each, begun));
  }

  private static Exception asException(Throwable reason) {
    return reason instanceof Exception exception ? exception : new RuntimeException(reason);
  }

  private synchronized void succeeded(RenewedLease renewed, long begun) {
    if (all.contains(renewed)) {
      extend(renewed, begun);
    }
  }

  private void failed(RenewedLease renewed, Exception e) {
    synchronized (this) {
      if (!all.contains(renewed)) {
        return;
      }
      long left = renewed.end - time.nanos();
      if (mayPass(e) && left > 0) {
        LOG.debug("A registration could not be renewed and is tried again.", e);
        after(Math.min(LONGEST_WAIT, left / 3), renewed);
        return;
      }
      all.remove(renewed);
    }
    try {
      renewed.givenUp.accept(e);
    } catch (RuntimeException failure) { // the others of its batch are concluded all the same
      LOG.warn("A registration that ended could not be reported: {}", failure.toString(), failure);
    }
  }

  private static boolean mayPass(Exception e) {
    return !(e instanceof LeaseException)
        && ThrowableConstants.retryable(e) == ThrowableConstants.INDEFINITE;
  }
}
