package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.lookup.entry.LookupAttributes;
import java.io.IOException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import net.jini.activation.ActivationGroup;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.export.Exporter;
import net.jini.lookup.entry.ServiceControlled;
import org.dfra.core.module.ModuleImpl;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseStatus;
import org.dfra.river.proxy.HeldLeaseRegistry;
import org.dfra.river.remote.ModuleAdmin;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One module server's administration, exported at its first use. */
final class ModuleAdministration implements ModuleAdmin, AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ModuleAdministration.class);

  /** The shutdown of a module takes longer than a query: it closes its device and unregisters. */
  private static final long DEADLINE_MILLIS = 10_000;

  private static final long LAST_ANSWER_NANOS = TimeUnit.SECONDS.toNanos(2);
  private static final long LOOK_AGAIN_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

  private final ModuleRegistration presence;
  private final ModuleImpl module;
  private final @Nullable ActivationID id;
  private final Exporter serverExporter;
  private final ModuleServer<?> server;
  private final DriverShutdown driverEnd;
  private final Exporter exporter;

  @GuardedBy("this")
  private @Nullable Remote stub;

  /**
   * @param module the served module
   * @param id the server's activation ID; null if no activation system created it
   * @param serverExporter the exporter of the server
   * @param server is halted and closed when an administrator stops it
   * @param driverEnd the shutdown of its driver
   */
  ModuleAdministration(
      ModuleRegistration presence,
      ModuleImpl module,
      String host,
      @Nullable ActivationID id,
      Exporter serverExporter,
      ModuleServer<?> server,
      DriverShutdown driverEnd) {
    this.presence = presence;
    this.module = module;
    this.id = id;
    this.serverExporter = serverExporter;
    this.server = server;
    this.driverEnd = driverEnd;
    this.exporter = Exporters.jeri(host, DEADLINE_MILLIS);
  }

  /** The remote proxy. */
  synchronized Remote stub() throws RemoteException {
    if (stub == null) {
      stub = exporter.export(this);
    }
    return stub;
  }

  @Override
  public Entry[] getLookupAttributes() {
    return presence.join().attributes();
  }

  @Override
  public synchronized void addLookupAttributes(Entry[] entries) {
    List<Entry> all = new ArrayList<>(presence.added());
    for (Entry each : entries) {
      refuseItsOwn(each);
      all.add(each);
    }
    presence.setAddedEntries(all);
  }

  @Override
  public synchronized void modifyLookupAttributes(Entry[] templates, Entry[] changes) {
    for (Entry each : templates) {
      refuseItsOwn(each);
    }
    Entry[] added = presence.added().toArray(Entry[]::new);
    presence.setAddedEntries(List.of(LookupAttributes.modify(added, templates, changes, true)));
  }

  private static void refuseItsOwn(Entry entry) {
    if (entry instanceof ServiceControlled) {
      throw new SecurityException(
          entry.getClass().getSimpleName()
              + " is what the module says of itself; add an entry of another kind");
    }
  }

  @Override
  public String[] getLookupGroups() {
    return presence.join().discovery().getGroups();
  }

  @Override
  public void addLookupGroups(String[] groups) throws RemoteException {
    multicast(() -> presence.join().discovery().addGroups(groups));
  }

  @Override
  public void removeLookupGroups(String[] groups) {
    presence.join().discovery().removeGroups(groups);
  }

  @Override
  public void setLookupGroups(String[] groups) throws RemoteException {
    multicast(() -> presence.join().discovery().setGroups(groups));
  }

  private interface DiscoveryChange {
    void run() throws IOException;
  }

  private static void multicast(DiscoveryChange body) throws RemoteException {
    try {
      body.run();
    } catch (IOException e) {
      throw new RemoteException("multicast discovery cannot be used here: " + e.getMessage(), e);
    }
  }

  @Override
  public LookupLocator[] getLookupLocators() {
    return presence.join().discovery().getLocators();
  }

  @Override
  public void addLookupLocators(LookupLocator[] locators) {
    presence.join().discovery().addLocators(locators);
  }

  @Override
  public void removeLookupLocators(LookupLocator[] locators) {
    presence.join().discovery().removeLocators(locators);
  }

  @Override
  public void setLookupLocators(LookupLocator[] locators) {
    presence.join().discovery().setLocators(locators);
  }

  @Override
  public Instant hostTime() {
    return Instant.now();
  }

  @Override
  public @Nullable String unreadiness() {
    return module.notReadyReason().orElse(null);
  }

  @Override
  public List<LeaseStatus> leases() {
    return module.leases().leases();
  }

  @Override
  public Set<LeaseHandle> heldLeases() {
    return HeldLeaseRegistry.all();
  }

  @Override
  public boolean revoke(LeaseHandle lease) {
    boolean ended = module.leases().revoke(lease);
    if (ended) {
      LOG.info("An administrator has revoked lease {}.", lease);
    }
    return ended;
  }

  @Override
  public void deactivate() throws RemoteException {
    end();
  }

  @Override
  public void destroy() throws RemoteException {
    server.halt(); // before the call to the activation system, which may not answer
    try {
      unregister();
    } finally {
      end(); // a halted module must not stay listed; if still registered, a call reactivates it
    }
  }

  private void unregister() throws RemoteException {
    if (id == null) {
      return;
    }
    try {
      ActivationGroup.getSystem().unregisterObject(id);
    } catch (UnknownObjectException e) {
      LOG.debug("{} was unregistered before.", id);
    } catch (ActivationException e) {
      throw new RemoteException(
          "the activation system does not let it go; it has ended, and starts again when called",
          e);
    }
  }

  /**
   * Shuts the module down, and returns when its driver is closed, by any thread: only then may
   * another driver use its device.
   *
   * @throws RemoteException if the driver is not closed in time; then the module stays active and
   *     accepts further requests. Also if the driver, or another part of the module, failed to
   *     close
   */
  private void end() throws RemoteException {
    server.halt();
    @Nullable RemoteException unclean = driverEnd.hasBegun() ? awaitDriver() : null;
    try {
      server.close();
    } catch (IllegalStateException e) {
      LOG.warn("A module did not end cleanly: {}", e.toString(), e);
      unclean = new RemoteException(String.valueOf(e.getMessage())); // without the cause
    }
    if (id != null) {
      try {
        ActivationGroup.inactive(id, serverExporter);
      } catch (ActivationException e) {
        LOG.debug("{} was inactive before.", id, e);
      }
    }
    if (unclean != null) { // the caller needs to know before it uses the device
      throw unclean;
    }
  }

  /** The failure of the driver's shutdown; null if there was none. */
  private @Nullable RemoteException awaitDriver() throws RemoteException {
    try {
      driverEnd.await(Duration.ofMillis(DEADLINE_MILLIS));
      return null;
    } catch (IllegalStateException e) {
      return new RemoteException("its driver did not end cleanly: " + e.getMessage());
    } catch (TimeoutException e) {
      throw new RemoteException(
          "its driver is still being closed after " + DEADLINE_MILLIS + " ms; ask again");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new RemoteException("interrupted while its driver was being closed; ask again");
    }
  }

  /** Closes the administration too, after the answer to the call that stopped the module. */
  @Override
  public synchronized void close() {
    if (stub == null) {
      return;
    }
    stub = null;
    Thread last =
        new Thread(
            () -> {
              long began = System.nanoTime();
              while (!exporter.unexport(false) && System.nanoTime() - began < LAST_ANSWER_NANOS) {
                LockSupport.parkNanos(this, LOOK_AGAIN_NANOS);
              }
              exporter.unexport(true);
            },
            "dfra-administration-end");
    last.setDaemon(true);
    last.start();
  }
}
