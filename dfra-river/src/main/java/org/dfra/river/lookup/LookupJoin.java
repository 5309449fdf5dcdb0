package org.dfra.river.lookup;

import java.io.IOException;
import java.io.Serializable;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.lookup.JoinManager;

/** Keeps a module registered with every lookup service that is found, until it is closed. */
public final class LookupJoin implements AutoCloseable {

  /**
   * How long all lookup services together may take to remove the module. The rest of a second is
   * for all other parts of the module's shutdown.
   */
  static final Duration CLOSE_TIMEOUT = Duration.ofMillis(800);

  private final Discovery discovery;
  private final JoinManager manager;
  private final RegistrationRenewer renewals;
  private final RegistrationExecutor threads;

  private LookupJoin(
      Discovery discovery,
      JoinManager manager,
      RegistrationRenewer renewals,
      RegistrationExecutor threads) {
    this.discovery = discovery;
    this.manager = manager;
    this.renewals = renewals;
    this.threads = threads;
  }

  /**
   * Starts the registration of a module and returns immediately. It registers with each lookup
   * service that it finds.
   *
   * @param proxy the proxy that clients receive
   * @param id the module's identity, the same after every restart
   * @param attributes the module's entries
   * @param groups discovery groups; none if empty
   * @param locators {@code jini://host:port} each
   * @param configuration entries of River's own components, such as {@code
   *     net.jini.lookup.JoinManager}
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  public static LookupJoin start(
      Serializable proxy,
      UUID id,
      Entry[] attributes,
      List<String> groups,
      List<String> locators,
      Configuration configuration)
      throws IOException, ConfigurationException {
    RefusalLogFilter.install();
    RegistrationExecutor threads = new RegistrationExecutor();
    Configuration timed =
        new SuppliedConfiguration(
            LookupTimings.configuration(configuration),
            Map.of("net.jini.lookup.JoinManager.taskManager", () -> threads));
    Discovery discovery = Discovery.start(groups, locators, Discovery.LOCATOR_RETRY, timed);
    try {
      RegistrationRenewer renewals = new RegistrationRenewer(LeaseBatches.SHARED);
      JoinManager manager =
          new JoinManager(
              proxy,
              attributes,
              new ServiceID(id.getMostSignificantBits(), id.getLeastSignificantBits()),
              discovery,
              renewals,
              new RegistrarPreparerConfiguration(timed));
      return new LookupJoin(discovery, manager, renewals, threads);
    } catch (IOException | ConfigurationException | RuntimeException e) {
      discovery.terminate();
      throw e;
    }
  }

  /** The discovery of lookup services; changes take effect immediately. */
  public Discovery discovery() {
    return discovery;
  }

  /** The module's present entries. */
  public Entry[] attributes() {
    return manager.getAttributes();
  }

  /** Replaces the module's entries. Returns immediately. */
  public void setAttributes(Entry[] attributes) {
    manager.setAttributes(attributes);
  }

  /**
   * Cancels the module's registrations with all lookup services. All are called at the same time,
   * and awaited for 0.8 s in total. A lookup service that does not answer by then removes the
   * module when its lease expires. A registration in progress is cancelled as soon as it is
   * granted.
   */
  @Override
  public void close() {
    long began = System.nanoTime();
    renewals.close();
    manager.terminate();
    discovery.terminate();
    try {
      threads.awaitEnd(left(began));
      renewals.awaitCancelled(left(began));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // no further wait; a later grant is cancelled
    }
  }

  private static Duration left(long began) {
    return CLOSE_TIMEOUT.minusNanos(System.nanoTime() - began);
  }
}
