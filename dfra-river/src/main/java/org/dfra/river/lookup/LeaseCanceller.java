package org.dfra.river.lookup;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Cancels leases, all at the same time.
 *
 * <p>Threads: a daemon for each lease, {@code dfra-lookup-cancel-n}, which ends when the lookup
 * service has answered or its call has failed. Another implementation's lookup service may have no
 * deadline on its calls; then the thread lasts until the connection breaks.
 */
final class LeaseCanceller {

  private static final Logger LOG = LoggerFactory.getLogger(LeaseCanceller.class);
  private static final AtomicInteger NAMES = new AtomicInteger();

  private final Set<Thread> underWay = ConcurrentHashMap.newKeySet();

  /** Starts the cancellation of a lease and returns immediately. */
  void cancelAsync(Lease lease) {
    Thread thread =
        new Thread(
            () -> {
              try {
                cancel(lease);
              } finally {
                underWay.remove(Thread.currentThread());
              }
            },
            "dfra-lookup-cancel-" + NAMES.incrementAndGet());
    thread.setDaemon(true);
    underWay.add(thread);
    try {
      thread.start();
    } catch (OutOfMemoryError e) { // no room for one more thread; the caller must not wait instead
      underWay.remove(thread);
      LOG.info("A registration could not be cancelled ({}); it ends with its lease.", e.toString());
    }
  }

  private static void cancel(Lease lease) {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      LOG.debug("A registration could not be cancelled; it ends with its lease.", e);
    } catch (RuntimeException e) { // thrown by the lookup service's own proxy
      LOG.warn(
          "A registration could not be cancelled ({}); it ends with its lease.", e.toString(), e);
    }
  }

  /**
   * Waits for all started cancellations.
   *
   * @param timeout the longest wait for all of them together
   * @throws InterruptedException if the waiting thread is interrupted
   */
  void await(Duration timeout) throws InterruptedException {
    long deadline = System.nanoTime() + timeout.toNanos();
    for (Thread thread : underWay) {
      long millis = (deadline - System.nanoTime()) / 1_000_000;
      if (millis > 0) {
        thread.join(millis);
      }
    }
  }
}
