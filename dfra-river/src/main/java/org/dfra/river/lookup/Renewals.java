package org.dfra.river.lookup;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.lease.LeaseListener;
import net.jini.lease.LeaseRenewalManager;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Renews the leases of registrations until it is closed; one that is granted later is cancelled.
 *
 * <p>River's join manager has a registration renewed whether or not it was terminated while the
 * lookup service answered. The module would be found, and not be there, for as long as its virtual
 * machine runs.
 */
final class Renewals extends LeaseRenewalManager implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(Renewals.class);

  private final Cancellations cancellations = new Cancellations();
  private final Object lock = new Object();
  private boolean closed; // guarded by lock

  Renewals(Configuration configuration) throws ConfigurationException {
    super(configuration);
  }

  @Override
  public void renewUntil(Lease lease, long expiration, LeaseListener listener) {
    if (!renewing(() -> super.renewUntil(lease, expiration, listener))) {
      cancelLate(lease);
    }
  }

  @Override
  public void renewUntil(Lease lease, long expiration, long duration, LeaseListener listener) {
    if (!renewing(() -> super.renewUntil(lease, expiration, duration, listener))) {
      cancelLate(lease);
    }
  }

  /**
   * {@inheritDoc} Returns at once: each lookup service is asked on a thread of its own, so one that
   * does not answer holds up neither the others nor the module's end.
   */
  @Override
  public void cancel(Lease lease) throws UnknownLeaseException {
    remove(lease);
    cancellations.begin(lease);
  }

  /**
   * Waits until the lookup services have answered all cancellations that have begun.
   *
   * @param patience how long at the longest; not at all where it is negative
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void awaitCancelled(Duration patience) throws InterruptedException {
    cancellations.await(patience);
  }

  /** Whether the renewal could begin. What begins before the close is known to who closes. */
  private boolean renewing(Runnable begin) {
    synchronized (lock) {
      if (!closed) {
        begin.run();
      }
      return !closed;
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

  /** Begins no renewal from now on. Those under way go on until they are cancelled. */
  @Override
  public void close() {
    synchronized (lock) {
      closed = true;
    }
  }
}
