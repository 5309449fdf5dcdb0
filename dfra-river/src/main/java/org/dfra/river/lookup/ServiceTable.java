package org.dfra.river.lookup;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
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
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.discovery.LocatedRegistrar;
import org.dfra.river.lookup.JiniModuleDirectory.ModuleConflict;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;
import org.jspecify.annotations.Nullable;

/**
 * Merges the contents of all lookup services into one table.
 *
 * <p>Listings under one service ID are one module. One lookup service takes precedence:
 *
 * <ul>
 *   <li>the first reachable one that lists it readably, as long as it is reachable and lists it.
 *       Another one changes nothing, whatever it lists or removes;
 *   <li>then the next one, in the order in which they listed it first;
 *   <li>if none is reachable any more, the last that took precedence, and the module is stale.
 * </ul>
 *
 * <p>The module is removed when a reachable lookup service has removed it and no other reachable
 * one lists it. An identical listing of an unreachable one is removed with it; a different one is
 * shown as stale.
 */
final class ServiceTable {

  private static final String UNKNOWN =
      "its proxy cannot be read; look whether it is of another version of DFRA";

  /** What lookup services list under one service ID. */
  private static final class ServiceListings {
    final Map<LocatedRegistrar, ListedService> all = new LinkedHashMap<>(); // in listing order
    @Nullable LocatedRegistrar counted; // what the table shows
    @Nullable ListedService shown; // in the listing of counted
  }

  private final ModuleTable table;
  private final BiFunction<UUID, List<Attributes>, Locality> locality;

  @GuardedBy("this")
  private final Map<UUID, ServiceListings> services = new HashMap<>();

  @GuardedBy("this")
  private final Map<LocatedRegistrar, String> hosts = new HashMap<>();

  private final Set<LocatedRegistrar> withinReach = new HashSet<>(); // guarded by this

  /** Unreachable ones that list something, and the time of their last answers. */
  @GuardedBy("this")
  private final Map<LocatedRegistrar, Instant> outOfReach = new HashMap<>();

  /**
   * @param locality how far away a module is, by its identity and attributes
   */
  ServiceTable(ModuleTable table, BiFunction<UUID, List<Attributes>, Locality> locality) {
    this.table = table;
    this.locality = locality;
  }

  /**
   * Records that a lookup service runs on a computer, and so does the robot whose lookup service it
   * is.
   *
   * @param host address or name of the computer
   */
  synchronized void setHost(LocatedRegistrar registrar, String host) {
    UUID id = uuid(registrar.getServiceID());
    hosts.put(registrar, host);
    ServiceListings listings = services.get(id);
    if (listings != null && listings.counted != null) {
      table.setHost(id, host(id, listings.counted));
    }
  }

  /** The host of the lookup service with this service ID, if known; its own claim first. */
  @GuardedBy("this")
  private String host(UUID id, LocatedRegistrar listing) {
    if (uuid(listing.getServiceID()).equals(id)) {
      return hosts.getOrDefault(listing, "");
    }
    return hosts.entrySet().stream()
        .filter(each -> uuid(each.getKey().getServiceID()).equals(id))
        .map(Map.Entry::getValue)
        .findFirst()
        .orElse("");
  }

  /** Replaces all listings of a lookup service. */
  synchronized void replaceAll(LocatedRegistrar registrar, Collection<ServiceItem> items) {
    replaceAll(registrar, items, Map.of());
  }

  /**
   * Replaces all listings of a lookup service.
   *
   * @param faults why proxies that are missing could not be read
   */
  synchronized void replaceAll(
      LocatedRegistrar registrar, Collection<ServiceItem> items, Map<ServiceID, String> faults) {
    withinReach.add(registrar);
    outOfReach.remove(registrar);
    Set<UUID> listed = new HashSet<>();
    for (ServiceItem item : items) {
      listed.add(uuid(item.serviceID));
      update(registrar, item, faults.getOrDefault(item.serviceID, UNKNOWN));
    }
    for (UUID id : List.copyOf(services.keySet())) {
      if (!listed.contains(id)) {
        remove(registrar, id);
      }
    }
    for (LocatedRegistrar each : List.copyOf(outOfReach.keySet())) {
      if (isFormer(each, registrar)) {
        forget(each);
      }
    }
  }

  /** Whether one lookup service was restarted as the other, which then has a new proxy. */
  private static boolean isFormer(LocatedRegistrar former, LocatedRegistrar now) {
    return former.getServiceID().equals(now.getServiceID())
        && former.address().equals(now.address());
  }

  @GuardedBy("this")
  private void forget(LocatedRegistrar former) {
    outOfReach.remove(former);
    hosts.remove(former);
    List.copyOf(services.keySet()).forEach(id -> remove(former, id));
  }

  /** Adds or replaces a listing of a reachable lookup service. */
  synchronized void update(LocatedRegistrar registrar, ServiceItem item) {
    update(registrar, item, UNKNOWN);
  }

  /**
   * Adds or replaces a listing of a reachable lookup service.
   *
   * @param fault why its proxy could not be read, if it is missing
   */
  synchronized void update(LocatedRegistrar registrar, ServiceItem item, String fault) {
    Optional<ListedService> service = ListedService.of(item, fault);
    if (service.isPresent()) {
      UUID id = uuid(item.serviceID);
      ServiceListings listings = services.computeIfAbsent(id, unused -> new ServiceListings());
      listings.all.put(registrar, service.get());
      show(id, listings);
    }
  }

  /** The lookup service that takes precedence; empty if none is reachable. */
  private Optional<LocatedRegistrar> counted(ServiceListings of) {
    @Nullable LocatedRegistrar last = of.counted;
    if (last != null && isReadable(of, last)) {
      return Optional.of(last);
    }
    Optional<LocatedRegistrar> readable =
        of.all.keySet().stream().filter(each -> isReadable(of, each)).findFirst();
    return readable.isPresent()
        ? readable
        : of.all.keySet().stream().filter(withinReach::contains).findFirst();
  }

  private boolean isReadable(ServiceListings of, LocatedRegistrar registrar) {
    @Nullable ListedService service = of.all.get(registrar);
    return service != null && service.isReadable() && withinReach.contains(registrar);
  }

  /** Shows the listing that takes precedence; false if no lookup service is reachable. */
  @GuardedBy("this")
  private boolean show(UUID id, ServiceListings listings) {
    Optional<LocatedRegistrar> counted = counted(listings);
    if (counted.isPresent()) {
      show(id, listings, counted.get());
    }
    return counted.isPresent();
  }

  @GuardedBy("this")
  private void show(UUID id, ServiceListings listings, LocatedRegistrar counted) {
    @Nullable ListedService service = listings.all.get(counted);
    @Nullable LocatedRegistrar last = listings.counted;
    @Nullable ListedService shown = listings.shown;
    if (service == null) {
      return;
    }
    if (shown != null && last != null && !counted.equals(last)) {
      if (!service.isReadable() && listings.all.containsKey(last)) {
        return; // a former readable listing is preferred, though it is stale
      } else if (!service.isReadable() || !service.isSameKind(shown)) {
        table.remove(id); // else the table would have both
      }
    }
    @Nullable Module module = service.module();
    @Nullable PersonaAttributes robot = service.robot();
    if (module != null) {
      table.put(id, module, service.attributes(), locality.apply(id, service.attributes()));
    } else if (robot != null) {
      table.put(id, robot, host(id, counted));
    }
    listings.counted = counted;
    listings.shown = service;
  }

  /** Removes a listing: the service unregistered, or its lease expired. */
  synchronized void remove(LocatedRegistrar registrar, UUID id) {
    ServiceListings listings = services.get(id);
    @Nullable ListedService removed = listings == null ? null : listings.all.remove(registrar);
    if (listings == null || removed == null || show(id, listings)) {
      return;
    }
    listings.all.values().removeIf(removed::isSameAs);
    Optional<LocatedRegistrar> other = listings.all.keySet().stream().findFirst();
    if (other.isPresent()) {
      show(id, listings, other.get());
      table.markStale(id, outOfReach.getOrDefault(other.get(), Instant.EPOCH));
    } else {
      services.remove(id);
      table.remove(id);
    }
  }

  /**
   * Records that a lookup service is unreachable.
   *
   * @param lastAnswered the time of its last answer
   */
  synchronized void markOutOfReach(LocatedRegistrar registrar, Instant lastAnswered) {
    if (!withinReach.remove(registrar)) {
      return;
    }
    boolean isListing = false;
    for (Map.Entry<UUID, ServiceListings> each : services.entrySet()) {
      if (each.getValue().all.containsKey(registrar)) {
        isListing = true;
        boolean isAnyWithinReach = show(each.getKey(), each.getValue());
        if (!isAnyWithinReach || registrar.equals(each.getValue().counted)) {
          table.markStale(each.getKey(), lastAnswered);
        }
      }
    }
    if (isListing) {
      outOfReach.put(registrar, lastAnswered);
    } else {
      hosts.remove(registrar);
    }
  }

  /** The modules in the table whose proxies cannot be read here, by path. */
  synchronized List<UnreadableModule> unreadable() {
    List<UnreadableModule> unreadable = new ArrayList<>();
    for (ServiceListings each : services.values()) {
      counted(each).map(each.all::get).map(ListedService::unreadable).ifPresent(unreadable::add);
    }
    unreadable.sort(Comparator.comparing(UnreadableModule::path));
    return unreadable;
  }

  /** Different listings of reachable lookup services under one service ID, by path. */
  synchronized List<ModuleConflict> conflicts() {
    List<ModuleConflict> conflicts = new ArrayList<>();
    services.forEach(
        (id, listings) ->
            counted(listings)
                .flatMap(each -> conflict(id, listings, each))
                .ifPresent(conflicts::add));
    conflicts.sort(Comparator.comparing(ModuleConflict::path));
    return conflicts;
  }

  private Optional<ModuleConflict> conflict(UUID id, ServiceListings of, LocatedRegistrar counted) {
    @Nullable ListedService service = of.all.get(counted);
    if (service == null) {
      return Optional.empty();
    }
    List<String> others = new ArrayList<>();
    for (Map.Entry<LocatedRegistrar, ListedService> other : of.all.entrySet()) {
      if (withinReach.contains(other.getKey()) && !service.isSameAs(other.getValue())) {
        others.add(other.getKey().hostAndPort());
      }
    }
    return others.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new ModuleConflict(service.path(), id.toString(), counted.hostAndPort(), others));
  }

  static UUID uuid(ServiceID id) {
    return new UUID(id.getMostSignificantBits(), id.getLeastSignificantBits());
  }
}
