package org.dfra.river.bootstrap;

import com.sun.jini.thread.ReadersWriter.ConcurrentLockException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import net.jini.export.Exporter;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.registrar.RegistrarLeaseLimiter;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.budget.ProcessBudgets;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Exports a lookup service by another exporter. While it is exported, limits its leases to the
 * longest that it grants, see {@link RegistrarLeaseLimiter}. For the entry {@code
 * com.sun.jini.reggie.serverExporter} of a registrar's Jini configuration.
 *
 * <p>Thread: one daemon, {@code registrar-leases}, from export to unexport.
 */
public final class RegistrarExporter implements Exporter {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrarExporter.class);

  private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Exporter exporter;
  private final @Nullable EventListenerPreparer listeners;
  private volatile @Nullable Thread thread;

  /**
   * @param exporter exports the lookup service
   * @throws IllegalArgumentException if that uses distributed garbage collection
   */
  public RegistrarExporter(Exporter exporter) {
    this(exporter, null);
  }

  /**
   * Exports a lookup service whose listeners are bounded.
   *
   * @param listeners the lookup service's {@code listenerPreparer}, which receives the registered
   *     listeners every second
   * @throws IllegalArgumentException if the exporter uses distributed garbage collection
   */
  public RegistrarExporter(Exporter exporter, @Nullable EventListenerPreparer listeners) {
    this.exporter =
        JeriExporters.requireNoDistributedGc(exporter, "the exporter of the lookup service");
    this.listeners = listeners;
  }

  @Override
  public Remote export(Remote registrar) throws ExportException {
    @Nullable RegistrarLeaseLimiter leases = leases(registrar);
    if (leases != null && listeners != null) {
      listeners.startTracking(); // before the first client can call
    }
    Remote proxy = exporter.export(registrar);
    exportBudgets(PeerAddress.of(proxy));
    if (leases != null) {
      Thread begun = new Thread(() -> watch(leases), "registrar-leases");
      begun.setDaemon(true);
      thread = begun;
      begun.start();
    }
    return proxy;
  }

  /** Its group may have no module that does. */
  private static void exportBudgets(@Nullable PeerAddress here) throws ExportException {
    Optional<ProcessBudgets> budgets = SecureProcess.budgets();
    if (here != null && budgets.isPresent()) {
      budgets.get().export(here.host());
    }
  }

  private static @Nullable RegistrarLeaseLimiter leases(Remote registrar) {
    try {
      return new RegistrarLeaseLimiter(registrar);
    } catch (ReflectiveOperationException e) {
      LOG.warn(
          "The leases of this lookup service go by the computer's clock, also where that is set"
              + " back: {}. Use reggie 2.2.2.",
          e.getMessage());
      return null;
    }
  }

  private void watch(RegistrarLeaseLimiter leases) {
    try {
      boolean hadFailed = false;
      while (thread == Thread.currentThread()) {
        try {
          limitLeases(leases);
          hadFailed = false;
        } catch (ConcurrentLockException e) {
          throw e;
        } catch (RuntimeException e) { // slots of listeners would no longer be released
          if (!hadFailed) { // not every second
            LOG.warn("The leases of this lookup service could not be checked; it continues.", e);
          }
          hadFailed = true;
        }
        LockSupport.parkNanos(this, PERIOD_NANOS);
      }
    } catch (ConcurrentLockException e) {
      LOG.debug("The lookup service ends.", e);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // they were made accessible
    }
  }

  private void limitLeases(RegistrarLeaseLimiter leases) throws IllegalAccessException {
    int cut = leases.shortenOverlong();
    if (cut > 0) {
      LOG.info("{} leases were longer than any that is granted, and are cut to that.", cut);
    }
    if (listeners != null) {
      listeners.retain(leases.listeners());
    }
  }

  @Override
  public boolean unexport(boolean force) {
    boolean unexported = exporter.unexport(force);
    if (unexported) {
      @Nullable Thread ending = thread;
      thread = null;
      LockSupport.unpark(ending);
    }
    return unexported;
  }
}
