package org.dfra.river.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.core.entry.Entry;
import net.jini.lookup.entry.Name;
import org.dfra.core.directory.AttributeFollower;
import org.dfra.core.directory.SelfDescription;
import org.dfra.persona.Attributes;
import org.dfra.river.entry.Entries;
import org.dfra.river.lookup.Join;
import org.dfra.river.proxy.ModuleProxy;

/**
 * A module in the lookup services: its proxy there, and its entries, which follow the module, at
 * most every {@value AttributeFollower#MILLIS} ms.
 */
final class ModulePresence implements AutoCloseable {

  private final Name name;
  private final Join join;
  private final AttributeFollower follower;
  private List<Attributes> own; // guarded by this
  private List<Entry> added = List.of(); // guarded by this

  /**
   * Begins to register the module. Returns at once.
   *
   * @throws IOException if multicast cannot be used or a locator is malformed
   */
  ModulePresence(
      SelfDescription self,
      ModuleProxy<?> proxy,
      ModuleActivation activation,
      Configuration configuration)
      throws IOException, ConfigurationException {
    this.name = new Name(self.driver().identification().path());
    this.own = self.now();
    this.join =
        Join.join(
            proxy,
            activation.id(),
            entries(),
            activation.lookupGroups(),
            activation.locators(),
            configuration);
    this.follower = new AttributeFollower(own, self::now, this::tell);
  }

  private synchronized void tell(List<Attributes> news) {
    own = news;
    join.setAttributes(entries());
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

  private synchronized Entry[] entries() {
    List<Entry> entries = new ArrayList<>(List.of(Entries.of(own)));
    entries.add(name);
    entries.addAll(added);
    return entries.toArray(Entry[]::new);
  }

  /** Takes the module out of every lookup service. */
  @Override
  public void close() {
    follower.close();
    join.close();
  }
}
