package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.lease.LeaseListener;
import net.jini.lease.LeaseRenewalEvent;
import net.jini.lease.LeaseRenewalManager;
import org.dfra.river.lookup.LeaseBatches.RenewedLease;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Renews the leases of a module's registrations until it is closed; cancels leases that are granted
 * later.
 *
 * <p>River's join manager starts the renewal of a registration even if it was terminated before the
 * lookup service answered. Clients would find the stopped module as long as its virtual machine
 * runs.
 *
 * <p>River's own manager uses the wall clock. Set back by an hour, it renews an hour late, long
 * after the lookup service has removed the module. {@link LeaseBatches} uses monotonic time, and
 * renews the leases of all modules of this virtual machine. If a lookup service does not know the
 * lease any more, the join manager registers again immediately.
 */
final class RegistrationRenewer extends LeaseRenewalManager implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrationRenewer.class);

  private final LeaseCanceller cancellations = new LeaseCanceller();
  private final LeaseBatches batches;

  @GuardedBy("this")
  private final Map<Lease, RenewedLease> renewals = new HashMap<>();

  @GuardedBy("this")
  private boolean closed;

  RegistrationRenewer(LeaseBatches batches) {
    this.batches = batches;
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
    synchronized (this) {
      if (!closed) {
        RenewedLease before =
            renewals.put(lease, batches.add(lease, duration, e -> givenUp(lease, listener, e)));
        if (before != null) { // an equal lease
          batches.remove(before);
        }
        return;
      }
    }
    cancelLate(lease);
  }

  private void givenUp(Lease lease, @Nullable LeaseListener listener, Exception reason) {
    synchronized (this) {
      renewals.remove(lease);
    }
    if (listener != null) {
      listener.notify(new LeaseRenewalEvent(this, lease, lease.getExpiration(), reason));
    }
  }

  @Override
  public void remove(Lease lease) throws UnknownLeaseException {
    RenewedLease renewal;
    synchronized (this) {
      renewal = renewals.remove(lease);
    }
    if (renewal == null) {
      throw new UnknownLeaseException("this lease is not renewed here");
    }
    batches.remove(renewal);
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
  public synchronized void clear() {
    renewals.values().forEach(batches::remove);
    renewals.clear();
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
  public synchronized void close() {
    closed = true;
  }
}
