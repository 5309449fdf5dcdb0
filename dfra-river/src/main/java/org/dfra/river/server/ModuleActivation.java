package org.dfra.river.server;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.jspecify.annotations.Nullable;

/**
 * What a module's server is activated with. The activation system keeps it, so a resurrected module
 * is the same as before, down to its service ID.
 *
 * @param module the module's description
 * @param id the module's identity, its service ID in every lookup service
 * @param created when the module was first registered with its robot, UTC
 * @param host address or name that the module's proxies carry
 * @param lookupGroups discovery groups whose lookup services it joins; none if empty
 * @param locators lookup services it joins by unicast, {@code jini://host:port} each
 * @param state folder of what of the module outlives its virtual machine, the module's alone; null
 *     where nothing is to
 */
public record ModuleActivation(
    ModuleDescription module,
    UUID id,
    Instant created,
    String host,
    List<String> lookupGroups,
    List<String> locators,
    @Nullable String state)
    implements Serializable {

  public ModuleActivation {
    lookupGroups = List.copyOf(lookupGroups);
    locators = List.copyOf(locators);
  }

  /** The same for a module that is registered for the first time, and remembers nothing. */
  public ModuleActivation(
      ModuleDescription module,
      UUID id,
      String host,
      List<String> lookupGroups,
      List<String> locators) {
    this(module, id, Instant.now(), host, lookupGroups, locators, null);
  }

  /** The same for a module that remembers nothing. */
  public ModuleActivation(
      ModuleDescription module,
      UUID id,
      Instant created,
      String host,
      List<String> lookupGroups,
      List<String> locators) {
    this(module, id, created, host, lookupGroups, locators, null);
  }
}
