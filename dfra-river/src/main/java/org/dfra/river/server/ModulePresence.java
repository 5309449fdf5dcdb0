package org.dfra.river.server;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.IntSupplier;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.entry.Entry;
import net.jini.lookup.entry.Name;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Identification;
import org.dfra.persona.Attributes;
import org.dfra.persona.Described;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.Join;
import org.dfra.river.proxy.ModuleProxy;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A module in the lookup services: its proxy there, and its entries, which follow the module.
 *
 * <p>Every {@value #FOLLOW_MILLIS} ms it looks whether the module's attributes are still those that
 * it is registered with, and registers the new ones if not. It looks rather than being told, so no
 * driver has to remember to tell, and no restless driver can flood the lookup services.
 *
 * <p>Threads: one daemon, {@code dfra-attributes}, looks for all modules of a virtual machine; it
 * never waits for a lookup service.
 */
final class ModulePresence implements AutoCloseable {

  /** Changes are looked for at this distance, in milliseconds. */
  static final long FOLLOW_MILLIS = 500;

  private static final Logger LOG = LoggerFactory.getLogger(ModulePresence.class);

  private static final ScheduledExecutorService LOOKER =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread thread = new Thread(task, "dfra-attributes");
            thread.setDaemon(true);
            return thread;
          });

  private final ModuleImpl driver;
  private final ModuleActivation activation;
  private final Instant activated;
  private final IntSupplier clients;
  private final Join join;
  private final ScheduledFuture<?> following;
  private List<Attributes> told; // guarded by this
  private List<Entry> added = List.of(); // guarded by this

  /**
   * Begins to register the module. Returns at once.
   *
   * @param activated when the module was started
   * @param clients how many clients hold a lease on it
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  ModulePresence(
      ModuleImpl driver,
      ModuleProxy<?> proxy,
      ModuleActivation activation,
      Instant activated,
      IntSupplier clients,
      Configuration configuration)
      throws IOException, ConfigurationException {
    this.driver = driver;
    this.activation = activation;
    this.activated = activated;
    this.clients = clients;
    this.told = attributes();
    this.join =
        Join.join(
            proxy,
            activation.id(),
            entries(),
            activation.lookupGroups(),
            activation.locators(),
            configuration);
    this.following =
        LOOKER.scheduleWithFixedDelay(
            this::follow, FOLLOW_MILLIS, FOLLOW_MILLIS, TimeUnit.MILLISECONDS);
  }

  /** Distance at which changes are looked for. */
  static Duration follows() {
    return Duration.ofMillis(FOLLOW_MILLIS);
  }

  /** Registers the module with its attributes of now, if they have changed. */
  private synchronized void follow() {
    try {
      List<Attributes> now = attributes();
      if (!now.equals(told)) {
        told = now;
        join.setAttributes(entries());
      }
    } catch (RuntimeException e) {
      LOG.warn("{}: its attributes cannot be told: {}", driver, e.toString(), e);
    }
  }

  /** What administrators have added to the module's own entries. */
  synchronized List<Entry> added() {
    return added;
  }

  /** Replaces what administrators have added. */
  synchronized void add(List<Entry> entries) {
    added = List.copyOf(entries);
    join.setAttributes(entries());
  }

  /** The registrations themselves. */
  Join join() {
    return join;
  }

  private List<Attributes> attributes() {
    Identification who = driver.identification();
    List<Attributes> attributes = new ArrayList<>();
    attributes.add(
        new ModuleAttributes(
            who.robot(),
            who.name(),
            driver.getClass().getName(),
            activation.host(),
            who.author(),
            who.version(),
            driver.readiness(),
            activation.created(),
            activated,
            clients.getAsInt()));
    if (driver instanceof Described described) {
      attributes.addAll(described.attributes());
    }
    return attributes;
  }

  private Entry[] entries() {
    List<Entry> entries = new ArrayList<>(List.of(Entries.of(told)));
    entries.add(new Name(driver.identification().path()));
    entries.addAll(added);
    return entries.toArray(Entry[]::new);
  }

  /** Takes the module out of every lookup service. */
  @Override
  public void close() {
    following.cancel(false);
    join.close();
  }
}
