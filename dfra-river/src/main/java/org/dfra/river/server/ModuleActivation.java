package org.dfra.river.server;

import java.io.Serializable;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.jspecify.annotations.Nullable;

/**
 * The activation data of a module's server. The activation system stores it, so a reactivated
 * module is the same as before, including its service ID.
 *
 * @param module the module's description
 * @param id the module's identity, its service ID in every lookup service
 * @param created when the module was first registered with its robot, UTC
 * @param host address or name that the module's proxies carry
 * @param lookupGroups discovery groups whose lookup services it joins; none if empty
 * @param locators lookup services it joins by unicast, {@code jini://host:port} each
 * @param state folder of the module's persistent state, used by this module alone; null for none
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

  /** The data of a module that is registered for the first time and has no stored state. */
  public ModuleActivation(
      ModuleDescription module,
      UUID id,
      String host,
      List<String> lookupGroups,
      List<String> locators) {
    this(module, id, Instant.now(), host, lookupGroups, locators, null);
  }

  /** The data of a module that has no stored state. */
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
