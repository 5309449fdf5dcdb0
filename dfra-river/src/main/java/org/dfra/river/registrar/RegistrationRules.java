package org.dfra.river.registrar;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import net.jini.core.lookup.ServiceID;
import org.dfra.directory.RegistrationRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * Which registrations a registrar takes from which computer:
 *
 * <ul>
 *   <li>While a registration lives, only the computer that made it replaces it. The robot's own
 *       computers may replace any.
 *   <li>The robot's service IDs and the robot's name are taken from its own computers only.
 *   <li>Other computers may have {@value #SERVICES_PER_ADDRESS} services and {@value
 *       #LISTENERS_PER_ADDRESS} listeners for each address, and {@value #FOREIGN_SERVICES} services
 *       and {@value #FOREIGN_LISTENERS} listeners in all.
 * </ul>
 *
 * <p>Not thread-safe: the caller holds a lock from the check until the registration is noted, so
 * that of two registrations of one ID the second sees the first.
 */
final class RegistrationRules {

  /** How many services another computer may register. */
  static final int SERVICES_PER_ADDRESS = 256;

  /** How many services all other computers together may register. */
  static final int FOREIGN_SERVICES = 2048;

  /** How many listeners another computer may register. */
  static final int LISTENERS_PER_ADDRESS = 128;

  /** How many listeners all other computers together may register. */
  static final int FOREIGN_LISTENERS = 1024;

  /** How many service IDs of the robot's modules are kept beyond their leases. */
  static final int RESERVED = 1024;

  /** What the registrar holds. */
  interface Contents {

    /** Those among some services whose leases live. */
    Set<ServiceID> liveServices(Set<ServiceID> among);

    /** Those among some listeners whose leases live. */
    Set<Long> liveListeners(Set<Long> among);
  }

  private final String robot;
  private final Contents contents;
  private final Registrations<ServiceID> services;
  private final Registrations<Long> listeners;

  /** IDs of the robot's modules: nobody takes one while its module is down. */
  private final Set<ServiceID> reserved = new LinkedHashSet<>();

  /**
   * @param robot name of the robot; empty for a registrar that belongs to no robot
   * @param contents what the registrar holds
   */
  RegistrationRules(String robot, Contents contents) {
    this.robot = robot;
    this.contents = contents;
    this.services =
        new Registrations<>(
            "services", SERVICES_PER_ADDRESS, FOREIGN_SERVICES, contents::liveServices);
    this.listeners =
        new Registrations<>(
            "listeners", LISTENERS_PER_ADDRESS, FOREIGN_LISTENERS, contents::liveListeners);
  }

  /**
   * Checks a registration of a service.
   *
   * @param from where it comes from
   * @param id the service ID that it takes; null for a new one
   * @param namesRobot whether its entries name the robot as the one that it belongs to
   * @throws RegistrationRefusedException if it is refused
   */
  void checkService(Source from, @Nullable ServiceID id, boolean namesRobot) {
    if (from.own()) {
      return;
    }
    checkEntries(from, namesRobot);
    if (id != null) {
      checkId(from, id);
    }
    services.checkBounds(from, id);
  }

  private void checkId(Source from, ServiceID id) {
    if (reserved.contains(id)) {
      throw new RegistrationRefusedException(
          "service ID "
              + id
              + " is refused to "
              + from
              + ": it belongs to a module of robot "
              + robot
              + ", which registers from its own computer; "
              + remedy());
    }
    if (contents.liveServices(Set.of(id)).isEmpty()) {
      return;
    }
    @Nullable Source holder = services.source(id);
    if (holder == null || !from.mayReplace(holder)) {
      throw new RegistrationRefusedException(
          "service ID "
              + id
              + " is refused to "
              + from
              + ": its registration from "
              + (holder == null ? "an unknown address" : holder)
              + " lives; register from there, or after its lease has ended");
    }
  }

  /**
   * Checks entries that are about to be attached.
   *
   * @param namesRobot whether they name the robot as the one that they belong to
   * @throws RegistrationRefusedException if they are refused
   */
  void checkEntries(Source from, boolean namesRobot) {
    if (!from.own() && namesRobot) {
      throw new RegistrationRefusedException(
          "entries that name robot "
              + robot
              + " are refused to "
              + from
              + ": its registrar takes modules of the robot from its own computer only; "
              + remedy());
    }
  }

  private String remedy() {
    return robot.isEmpty()
        ? "register from there"
        : "register from there, or add the address to <registrar from=\"…\"> in its XML and bring"
            + " the robot up again";
  }

  /**
   * Checks a registration of a listener.
   *
   * @throws RegistrationRefusedException if it is refused
   */
  void checkListener(Source from) {
    if (!from.own()) {
      listeners.checkBounds(from, null);
    }
  }

  /**
   * A service is registered.
   *
   * @param ofRobot whether it is a module of the robot
   */
  void registered(Source from, ServiceID id, boolean ofRobot) {
    services.put(id, from);
    if (from.own() && ofRobot) {
      boolean unused = reserved.remove(id); // the newest comes last
      reserved.add(id);
      if (reserved.size() > RESERVED) {
        reserved.remove(reserved.iterator().next());
      }
    }
  }

  /** A listener is registered. */
  void listening(Source from, long event) {
    listeners.put(event, from);
  }

  /** How many services and listeners are noted, for tests. */
  int noted() {
    return services.sources.size() + listeners.sources.size();
  }

  /**
   * Where registrations of one kind come from. What has ended is dropped when a bound is reached,
   * and when there are twice as many as were left the last time.
   */
  private static final class Registrations<K> {

    private static final int FEW = 64;

    private final String kind;
    private final int perAddress;
    private final int inAll;
    private final UnaryOperator<Set<K>> live;
    private final Map<K, Source> sources = new LinkedHashMap<>();
    private int next = FEW; // size at which it drops what has ended

    Registrations(String kind, int perAddress, int inAll, UnaryOperator<Set<K>> live) {
      this.kind = kind;
      this.perAddress = perAddress;
      this.inAll = inAll;
      this.live = live;
    }

    @Nullable Source source(K key) {
      return sources.get(key);
    }

    void put(K key, Source from) {
      sources.put(key, from);
      if (sources.size() >= next) {
        dropEnded();
      }
    }

    private void dropEnded() {
      Set<K> stay = live.apply(Collections.unmodifiableSet(sources.keySet()));
      boolean unused = sources.keySet().retainAll(stay);
      next = Math.max(FEW, 2 * sources.size());
    }

    /** One that replaces another of the same source needs no more room. */
    void checkBounds(Source from, @Nullable K replaced) {
      if (replaced != null && from.equals(sources.get(replaced))) {
        return;
      }
      if (fault(from) != null) {
        dropEnded();
        @Nullable String fault = fault(from);
        if (fault != null) {
          throw new RegistrationRefusedException(fault);
        }
      }
    }

    private @Nullable String fault(Source from) {
      long foreign = 0;
      long same = 0;
      for (Source each : sources.values()) {
        if (!each.own()) {
          foreign++;
          if (each.equals(from)) {
            same++;
          }
        }
      }
      String refused = "one more of the " + kind + " of " + from + " is refused: ";
      String remedy = "; end some, or wait until their leases end";
      if (same >= perAddress) {
        return refused + same + " from that address >= " + perAddress + " allowed" + remedy;
      }
      return foreign >= inAll
          ? refused + foreign + " from all other computers >= " + inAll + " allowed" + remedy
          : null;
    }
  }
}
