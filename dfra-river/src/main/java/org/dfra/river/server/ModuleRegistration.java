package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.entry.Entry;
import net.jini.lookup.entry.Name;
import org.dfra.core.directory.AttributeMonitor;
import org.dfra.core.directory.SelfDescription;
import org.dfra.persona.Attributes;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.LookupJoin;
import org.dfra.river.proxy.ModuleProxy;

/**
 * A module's registration with lookup services: its proxy there, and its entries. Changes of the
 * module update them, at most every {@value AttributeMonitor#POLL_MILLIS} ms.
 */
final class ModuleRegistration implements AutoCloseable {

  private final Name name;
  private final LookupJoin join;
  private final AttributeMonitor follower;

  @GuardedBy("this")
  private List<Attributes> own;

  @GuardedBy("this")
  private List<Entry> added = List.of();

  /**
   * Starts the registration of the module. Returns immediately.
   *
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  ModuleRegistration(
      SelfDescription self,
      ModuleProxy<?> proxy,
      ModuleActivation activation,
      Configuration configuration)
      throws IOException, ConfigurationException {
    this.name = new Name(self.driver().identification().path());
    this.own = self.attributes();
    this.join =
        LookupJoin.start(
            proxy,
            activation.id(),
            entries(),
            activation.lookupGroups(),
            activation.locators(),
            configuration);
    this.follower = AttributeMonitor.start(own, self::attributes, this::publish);
  }

  private synchronized void publish(List<Attributes> attributes) {
    own = attributes;
    join.setAttributes(entries());
  }

  /** The entries that administrators have added. */
  synchronized List<Entry> added() {
    return added;
  }

  /** Replaces the entries that administrators have added. */
  synchronized void setAddedEntries(List<Entry> entries) {
    added = List.copyOf(entries);
    join.setAttributes(entries());
  }

  /** The registrations themselves. */
  LookupJoin join() {
    return join;
  }

  private synchronized Entry[] entries() {
    List<Entry> entries = new ArrayList<>(List.of(Entries.toEntries(own)));
    entries.add(name);
    entries.addAll(added);
    return entries.toArray(Entry[]::new);
  }

  /** Cancels the module's registrations with all lookup services. */
  @Override
  public void close() {
    follower.close();
    join.close();
  }
}
