package org.dfra.river.lookup;

import java.time.Instant;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.BiFunction;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import org.dfra.core.directory.ModuleTable;
import org.dfra.directory.Locality;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.entry.Entries;

/**
 * Which lookup service holds what, put together into one table.
 *
 * <p>What several hold under one service ID is one module. It is fresh while one of those within
 * reach holds it, stale when none is within reach any more, and gone when one within reach let go
 * of it and no other such one holds it.
 */
final class Sightings {

  private static final String UNKNOWN =
      "its proxy cannot be read; look whether it is of another version of DFRA";

  private final ModuleTable table;
  private final BiFunction<UUID, List<Attributes>, Locality> locality;
  private final Map<UUID, Set<ServiceID>> holders = new HashMap<>(); // guarded by this
  private final Map<UUID, UnreadableModule> unreadable = new HashMap<>(); // guarded by this
  private final Map<UUID, String> hosts = new HashMap<>(); // of lookup services; guarded by this
  private final Set<ServiceID> withinReach = new HashSet<>(); // guarded by this

  /**
   * @param locality how far away a module is, by its identity and attributes
   */
  Sightings(ModuleTable table, BiFunction<UUID, List<Attributes>, Locality> locality) {
    this.table = table;
    this.locality = locality;
  }

  /**
   * A lookup service runs on this computer, and so does the robot whose lookup service it is.
   *
   * @param host address or name of the computer
   */
  synchronized void runsAt(ServiceID registrar, String host) {
    UUID id = uuid(registrar);
    if (!host.equals(hosts.put(id, host))) {
      table.place(id, host);
    }
  }

  /** A lookup service tells all that it holds. */
  synchronized void all(ServiceID registrar, Collection<ServiceItem> items) {
    all(registrar, items, Map.of());
  }

  /**
   * The same.
   *
   * @param faults why proxies that are missing could not be read
   */
  synchronized void all(
      ServiceID registrar, Collection<ServiceItem> items, Map<ServiceID, String> faults) {
    withinReach.add(registrar);
    Set<UUID> told = new HashSet<>();
    for (ServiceItem item : items) {
      told.add(uuid(item.serviceID));
      seen(registrar, item, faults.getOrDefault(item.serviceID, UNKNOWN));
    }
    Set.copyOf(holders.keySet()).stream()
        .filter(id -> !told.contains(id) && isHolding(registrar, id))
        .forEach(id -> gone(registrar, id));
  }

  private boolean isHolding(ServiceID registrar, UUID id) {
    return holders.getOrDefault(id, Set.of()).contains(registrar);
  }

  /** A lookup service within reach holds this, as it is told here. */
  synchronized void seen(ServiceID registrar, ServiceItem item) {
    seen(registrar, item, UNKNOWN);
  }

  /**
   * The same.
   *
   * @param fault why its proxy could not be read, where it is missing
   */
  synchronized void seen(ServiceID registrar, ServiceItem item, String fault) {
    UUID id = uuid(item.serviceID);
    List<Attributes> attributes = Entries.records(item.attributeSets);
    Optional<ModuleAttributes> own =
        attributes.stream()
            .filter(ModuleAttributes.class::isInstance)
            .map(ModuleAttributes.class::cast)
            .findFirst();
    if (item.service instanceof Module module && own.isPresent()) {
      unreadable.remove(id);
      table.put(id, module, attributes, locality.apply(id, attributes));
    } else if (item.service == null && own.isPresent()) {
      ModuleAttributes of = own.get();
      unreadable.put(
          id, new UnreadableModule(of.robot(), of.name(), of.host(), id.toString(), fault));
    } else {
      PersonaAttributes robot =
          attributes.stream()
              .filter(PersonaAttributes.class::isInstance)
              .map(PersonaAttributes.class::cast)
              .findFirst()
              .orElse(null);
      if (robot == null) {
        return;
      }
      table.put(id, robot, hosts.getOrDefault(id, ""));
    }
    holders.computeIfAbsent(id, key -> new HashSet<>()).add(registrar);
  }

  /** A lookup service within reach holds this no longer: it left, or its lease ran out. */
  synchronized void gone(ServiceID registrar, UUID id) {
    Set<ServiceID> holding = holders.get(id);
    if (holding == null) {
      return;
    }
    holding.remove(registrar);
    if (holding.stream().noneMatch(withinReach::contains)) {
      holders.remove(id);
      unreadable.remove(id);
      table.remove(id);
    }
  }

  /**
   * A lookup service is out of reach.
   *
   * @param vouched when it last answered
   */
  synchronized void lost(ServiceID registrar, Instant vouched) {
    if (!withinReach.remove(registrar)) {
      return;
    }
    holders.forEach(
        (id, holding) -> {
          if (holding.contains(registrar) && holding.stream().noneMatch(withinReach::contains)) {
            unreadable.remove(id);
            table.stale(id, vouched);
          }
        });
  }

  /** The modules whose proxies cannot be read here, by path. */
  synchronized List<UnreadableModule> unreadable() {
    return unreadable.values().stream()
        .sorted(Comparator.comparing(UnreadableModule::path))
        .toList();
  }

  static UUID uuid(ServiceID id) {
    return new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }
}
