package org.dfra.river.discovery;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import net.jini.core.lookup.ServiceID;

/**
 * The lookup services that a {@link SharedMulticastSearch} has found, whose lock guards this.
 * Several may claim one service ID. Their number is bounded, in all and for each address.
 */
final class FoundRegistrars {

  /** Maximum number of lookup services in all. */
  static final int MAX_REGISTRARS = DiscoveryCandidates.MAX_CANDIDATES;

  /** Maximum number for one address, so that no single computer takes all slots. */
  static final int PER_ADDRESS = 32;

  private final Map<LocatedRegistrar, FoundRegistrar> found = new LinkedHashMap<>();

  /** The service IDs that they claim, without duplicates. */
  Collection<ServiceID> serviceIds() {
    return found.keySet().stream().map(LocatedRegistrar::getServiceID).distinct().toList();
  }

  /** A copy of the current list. */
  List<FoundRegistrar> all() {
    return List.copyOf(found.values());
  }

  /**
   * The lookup services that claim a service ID and were found at a host.
   *
   * @param host as it was announced, or the address that answered
   */
  List<FoundRegistrar> of(ServiceID id, String host) {
    return found.values().stream()
        .filter(each -> each.registrar.getServiceID().equals(id) && each.host.equals(host))
        .toList();
  }

  boolean contains(LocatedRegistrar registrar) {
    return found.containsKey(registrar);
  }

  /** Whether it is found already, or there is room for it. */
  boolean isRoomFor(LocatedRegistrar registrar) {
    if (found.containsKey(registrar)) {
      return true;
    }
    long there =
        found.keySet().stream().filter(each -> each.address().equals(registrar.address())).count();
    return there < PER_ADDRESS && found.size() < MAX_REGISTRARS;
  }

  /**
   * Adds one, unless it is present already.
   *
   * @param host as it was announced, or the address that answered
   * @param groups of which it is a member now
   * @param now nanoseconds of the system
   * @return the entry
   */
  FoundRegistrar add(LocatedRegistrar registrar, String host, Collection<String> groups, long now) {
    FoundRegistrar present = found.get(registrar);
    if (present == null) {
      present = new FoundRegistrar(registrar, host, groups, now);
      found.put(registrar, present);
    } else {
      present.groups = groups;
      present.seenAt = now;
    }
    return present;
  }

  /** Removes one; false if it is not present. */
  boolean remove(LocatedRegistrar registrar) {
    return found.remove(registrar) != null;
  }

  /** As {@link #remove(LocatedRegistrar)}, unless it was found again meanwhile. */
  boolean remove(FoundRegistrar registrar) {
    return found.remove(registrar.registrar, registrar);
  }

  void clear() {
    found.clear();
  }

  /**
   * A lookup service that a {@link SharedMulticastSearch} has found, whose lock guards the mutable
   * fields.
   */
  static final class FoundRegistrar {

    final LocatedRegistrar registrar;
    final String host;
    Collection<String> groups; // guarded by the search, like the next fields
    long seenAt; // nanoseconds of the system, like the next field
    long checkedAt;
    boolean isBeingChecked;

    FoundRegistrar(LocatedRegistrar registrar, String host, Collection<String> groups, long now) {
      this.registrar = registrar;
      this.host = host;
      this.groups = groups;
      this.seenAt = now;
      this.checkedAt = now;
    }
  }
}
