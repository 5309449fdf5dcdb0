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
import org.dfra.time.Scheduler;

/** Keeps a module registered with every lookup service that is found, until it is closed. */
public final class LookupJoin implements AutoCloseable {

  /**
   * How long all lookup services together may take to forget the module. The rest of a second is
   * for all else that the end of a module takes.
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
   * Begins to register a module. Returns at once; lookup services are joined as they are found.
   *
   * @param proxy what clients get
   * @param id the module's identity, the same after every restart
   * @param attributes what it is registered with
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
      RegistrationRenewer renewals = new RegistrationRenewer(Scheduler.system());
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

  /** How lookup services are found; what is changed there counts at once. */
  public Discovery discovery() {
    return discovery;
  }

  /** What the module is registered with. */
  public Entry[] attributes() {
    return manager.getAttributes();
  }

  /** Registers the module with other attributes from now on. Returns at once. */
  public void setAttributes(Entry[] attributes) {
    manager.setAttributes(attributes);
  }

  /**
   * Takes the module out of every lookup service it joined, or was about to join. All of them are
   * asked at the same time, and awaited for 0.8 s in all. A lookup service that does not answer by
   * then forgets the module when its lease expires. A registration that is under way is cancelled
   * as soon as it is granted.
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
      Thread.currentThread().interrupt(); // the caller is in a hurry; what is granted is cancelled
    }
  }

  private static Duration left(long began) {
    return CLOSE_TIMEOUT.minusNanos(System.nanoTime() - began);
  }
}
