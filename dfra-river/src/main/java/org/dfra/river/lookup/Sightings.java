package org.dfra.river.lookup;

import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
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

  private final ModuleTable table;
  private final BiFunction<UUID, List<Attributes>, Locality> locality;
  private final Map<UUID, Set<ServiceID>> holders = new HashMap<>(); // guarded by this
  private final Set<ServiceID> withinReach = new HashSet<>(); // guarded by this

  /**
   * @param locality how far away a module is, by its identity and attributes
   */
  Sightings(ModuleTable table, BiFunction<UUID, List<Attributes>, Locality> locality) {
    this.table = table;
    this.locality = locality;
  }

  /** A lookup service tells all that it holds. */
  synchronized void all(ServiceID registrar, Collection<ServiceItem> items) {
    withinReach.add(registrar);
    Set<UUID> told = new HashSet<>();
    for (ServiceItem item : items) {
      told.add(uuid(item.serviceID));
      seen(registrar, item);
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
    UUID id = uuid(item.serviceID);
    List<Attributes> attributes = Entries.records(item.attributeSets);
    if (item.service instanceof Module module
        && attributes.stream().anyMatch(ModuleAttributes.class::isInstance)) {
      table.put(id, module, attributes, locality.apply(id, attributes));
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
      table.put(id, robot);
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
            table.stale(id, vouched);
          }
        });
  }

  static UUID uuid(ServiceID id) {
    return new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }
}
