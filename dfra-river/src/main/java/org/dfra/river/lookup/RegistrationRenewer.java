package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.constants.ThrowableConstants;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseException;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.lease.LeaseListener;
import net.jini.lease.LeaseRenewalEvent;
import net.jini.lease.LeaseRenewalManager;
import org.dfra.river.call.CallThreads;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Renews the leases of registrations until it is closed; cancels leases that are granted later.
 *
 * <p>River's join manager starts the renewal of a registration even if it was terminated before the
 * lookup service answered. Clients would find the stopped module as long as its virtual machine
 * runs.
 *
 * <p>River's own manager uses the wall clock. Set back by an hour, it renews an hour late, long
 * after the lookup service has removed the module. Here a lease is a span of monotonic time that
 * begins with its grant. It is renewed after a third of the span. If a lookup service does not know
 * the lease any more, the join manager registers again immediately.
 *
 * <p>Threads: daemons, {@code dfra-registration-n}, exist during calls, so a lookup service that
 * does not answer delays no renewal at another one.
 */
final class RegistrationRenewer extends LeaseRenewalManager implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrationRenewer.class);

  private final LeaseCanceller cancellations = new LeaseCanceller();

  /** The longest delay before a failed renewal is repeated. */
  private static final long LONGEST_WAIT = LookupTimings.MAX_RETRY_DELAY.toNanos();

  private static final long SHORTEST_WAIT = TimeUnit.MILLISECONDS.toNanos(50);

  private static final ThreadPoolExecutor CALLERS = CallThreads.pool("dfra-registration-");

  private final Scheduler time;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();
  private final Object lock = new Object();

  @GuardedBy("lock")
  private final Map<Lease, RenewedLease> renewals = new HashMap<>();

  @GuardedBy("lock")
  private boolean closed;

  RegistrationRenewer(Scheduler time) {
    this.time = time;
  }

  /** A lease that is renewed. */
  private static final class RenewedLease {
    final Lease lease;
    final long duration;
    final @Nullable LeaseListener listener;
    long end; // guarded by lock
    @Nullable ScheduledTask next; // guarded by lock

    RenewedLease(Lease lease, long duration, @Nullable LeaseListener listener) {
      this.lease = lease;
      this.duration = duration;
      this.listener = listener;
    }
  }

  @Override
  public void renewUntil(Lease lease, long expiration, LeaseListener listener) {
    renewUntil(lease, expiration, LookupTimings.MAX_LEASE.toMillis(), listener);
  }

  /**
   * {@inheritDoc}
   *
   * @param expiration ignored: registrations are renewed until they are cancelled
   */
  @Override
  public void renewUntil(
      Lease lease, long expiration, long duration, @Nullable LeaseListener listener) {
    RenewedLease renewal = new RenewedLease(lease, duration, listener);
    synchronized (lock) {
      if (!closed) {
        renewals.put(lease, renewal);
        extend(renewal, time.nanos());
        return;
      }
    }
    cancelLate(lease);
  }

  /** Records that a lease was granted or renewed, no earlier than {@code begun}. */
  private void extend(RenewedLease renewal, long begun) {
    long granted = renewal.lease.getExpiration() - System.currentTimeMillis();
    // A simultaneous change of the clock makes it look longer or expired. Both are harmless.
    long nanos = TimeUnit.MILLISECONDS.toNanos(Math.min(granted, renewal.duration));
    renewal.end = begun + nanos;
    after(nanos / 3, renewal);
  }

  private void after(long nanos, RenewedLease renewal) {
    renewal.next = time.after(Math.max(SHORTEST_WAIT, nanos), () -> send(renewal));
  }

  private void send(RenewedLease renewal) {
    try {
      CALLERS.execute(() -> renew(renewal));
    } catch (RejectedExecutionException | OutOfMemoryError e) { // no further thread
      LOG.warn("A registration cannot be renewed now and is tried again: {}", e.toString());
      synchronized (lock) {
        after(LONGEST_WAIT, renewal);
      }
    }
  }

  private void renew(RenewedLease renewal) {
    synchronized (lock) {
      if (renewals.get(renewal.lease) != renewal) {
        return; // removed meanwhile
      }
    }
    Thread.currentThread().setContextClassLoader(loader);
    long begun = time.nanos();
    try {
      renewal.lease.renew(renewal.duration);
      synchronized (lock) {
        if (renewals.get(renewal.lease) == renewal) {
          extend(renewal, begun);
        }
      }
    } catch (LeaseException | RemoteException | RuntimeException e) {
      failed(renewal, e);
    } finally {
      Thread.currentThread().setContextClassLoader(null);
    }
  }

  private void failed(RenewedLease renewal, Exception e) {
    synchronized (lock) {
      if (renewals.get(renewal.lease) != renewal) {
        return;
      }
      long left = renewal.end - time.nanos();
      boolean mayPass = ThrowableConstants.retryable(e) == ThrowableConstants.INDEFINITE;
      if (mayPass && !(e instanceof LeaseException) && left > 0) {
        LOG.debug("A registration could not be renewed and is tried again.", e);
        after(Math.min(LONGEST_WAIT, left / 3), renewal);
        return;
      }
      renewals.remove(renewal.lease);
    }
    if (renewal.listener != null) {
      renewal.listener.notify(
          new LeaseRenewalEvent(this, renewal.lease, renewal.lease.getExpiration(), e));
    }
  }

  @Override
  public void remove(Lease lease) throws UnknownLeaseException {
    synchronized (lock) {
      RenewedLease renewal = renewals.remove(lease);
      if (renewal == null) {
        throw new UnknownLeaseException("this lease is not renewed here");
      }
      if (renewal.next != null) {
        renewal.next.cancel();
      }
    }
  }

  /**
   * {@inheritDoc} Returns immediately: each lookup service is called on its own thread. One that
   * does not answer delays neither the others nor the module's shutdown.
   */
  @Override
  public void cancel(Lease lease) throws UnknownLeaseException {
    remove(lease);
    cancellations.cancelAsync(lease);
  }

  /**
   * Waits for the answers to all started cancellations.
   *
   * @param timeout the longest wait; none if negative
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void awaitCancelled(Duration timeout) throws InterruptedException {
    cancellations.await(timeout);
  }

  @Override
  public void clear() {
    synchronized (lock) {
      renewals.values().stream()
          .map(each -> each.next)
          .filter(next -> next != null)
          .forEach(ScheduledTask::cancel);
      renewals.clear();
    }
  }

  private static void cancelLate(Lease lease) {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      LOG.info(
          "A registration that was granted after its module had been closed could not be cancelled"
              + " ({}); it ends with its lease, at {}.",
          e.toString(),
          Instant.ofEpochMilli(lease.getExpiration()));
    }
  }

  /** Starts no further renewal. Running ones continue until they are cancelled. */
  @Override
  public void close() {
    synchronized (lock) {
      closed = true;
    }
  }
}
