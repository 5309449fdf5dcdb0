package org.dfra.river.registrar;

import java.net.InetAddress;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import net.jini.core.lookup.ServiceID;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.access.RemoteCaller;
import org.jspecify.annotations.Nullable;

/**
 * Decides which registrations a registrar accepts from which computer:
 *
 * <ul>
 *   <li>While a registration is valid, only the computer that made it replaces it. The robot's
 *       hosts may replace any.
 *   <li>The robot's service IDs and the robot's name are accepted from its hosts only.
 *   <li>Other computers may have {@value #MAX_SERVICES_PER_ADDRESS} services and {@value
 *       #MAX_LISTENERS_PER_ADDRESS} listeners for each address, and {@value #MAX_FOREIGN_SERVICES}
 *       services and {@value #MAX_FOREIGN_LISTENERS} listeners in all. The memory of each is
 *       limited, and so is their total memory.
 * </ul>
 *
 * <p>Not thread-safe: the caller holds a lock from the check until the registration is recorded. So
 * of two registrations of one ID, the second check sees the first registration.
 */
final class RegistrationRules {

  /** How many services another computer may register. */
  static final int MAX_SERVICES_PER_ADDRESS = 256;

  /** How many services all other computers together may register. */
  static final int MAX_FOREIGN_SERVICES = 2048;

  /** How many listeners another computer may register. */
  static final int MAX_LISTENERS_PER_ADDRESS = 128;

  /** How many listeners all other computers together may register. */
  static final int MAX_FOREIGN_LISTENERS = 1024;

  /** Bytes of one service; a DFRA module has about 5 kB. */
  static final long MAX_SERVICE_BYTES = 64 << 10;

  /** Bytes of one listener with its template. */
  static final long MAX_LISTENER_BYTES = 64 << 10;

  /** How many service IDs of the robot's modules stay reserved beyond their leases. */
  static final int MAX_RESERVED_IDS = 1024;

  /** The registrar's contents. */
  interface LiveRegistrations {

    /** The services among these whose leases are valid. */
    Set<ServiceID> liveServices(Set<ServiceID> among);

    /** The listeners among these whose leases are valid. */
    Set<Long> liveListeners(Set<Long> among);
  }

  private final String robot;
  private final LiveRegistrations contents;
  private final QuotaTable<ServiceID> services;
  private final QuotaTable<Long> listeners;

  /** IDs of the robot's modules: no other computer may take one while its module is down. */
  private final Set<ServiceID> reserved = new LinkedHashSet<>();

  /**
   * @param robot name of the robot; empty for a registrar that belongs to no robot
   * @param contents the registrar's contents
   */
  RegistrationRules(String robot, LiveRegistrations contents) {
    this.robot = robot;
    this.contents = contents;
    this.services =
        new QuotaTable<>(
            "services",
            MAX_SERVICES_PER_ADDRESS,
            MAX_FOREIGN_SERVICES,
            MAX_SERVICE_BYTES,
            contents::liveServices);
    this.listeners =
        new QuotaTable<>(
            "listeners",
            MAX_LISTENERS_PER_ADDRESS,
            MAX_FOREIGN_LISTENERS,
            MAX_LISTENER_BYTES,
            contents::liveListeners);
  }

  /**
   * Checks a registration of a service.
   *
   * @param from its origin
   * @param id its service ID; null for a new one
   * @param namesRobot whether its entries name the robot as the one that it belongs to
   * @param bytes its size
   * @throws RegistrationRefusedException if it is refused
   */
  void checkService(
      RegistrationOrigin from, @Nullable ServiceID id, boolean namesRobot, long bytes) {
    if (from.isRobotHost()) {
      return;
    }
    checkEntries(from, namesRobot);
    if (id != null) {
      checkId(from, id);
    }
    services.checkBounds(from, id, bytes);
  }

  /**
   * Checks the size of a service after a change.
   *
   * @param bytes its size then, at most
   * @throws RegistrationRefusedException if that is too much
   */
  void checkGrowth(RegistrationOrigin from, ServiceID id, long bytes) {
    if (!from.isRobotHost()) {
      services.checkBounds(from, id, bytes);
    }
  }

  private void checkId(RegistrationOrigin from, ServiceID id) {
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
    @Nullable RegistrationOrigin holder = services.source(id);
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
   * Checks entries before they are added.
   *
   * @param namesRobot whether they name the robot as the one that they belong to
   * @throws RegistrationRefusedException if they are refused
   */
  void checkEntries(RegistrationOrigin from, boolean namesRobot) {
    if (!from.isRobotHost() && namesRobot) {
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
        : "register from there, or add the address to <registrar module-hosts=\"…\"> in its XML and bring"
            + " the robot up again";
  }

  /**
   * Checks a registration of a listener.
   *
   * @param bytes its size
   * @throws RegistrationRefusedException if it is refused
   */
  void checkListener(RegistrationOrigin from, long bytes) {
    if (!from.isRobotHost()) {
      listeners.checkBounds(from, null, bytes);
    }
  }

  /**
   * Records a registered service.
   *
   * @param ofRobot whether it is a module of the robot
   * @param bytes its size
   */
  void addService(RegistrationOrigin from, ServiceID id, boolean ofRobot, long bytes) {
    services.put(id, from, bytes);
    if (from.isRobotHost() && ofRobot) {
      boolean unused = reserved.remove(id); // moves it to the end
      reserved.add(id);
      if (reserved.size() > MAX_RESERVED_IDS) {
        reserved.remove(reserved.iterator().next());
      }
    }
  }

  /** Records the new size of a changed service, in bytes. */
  void setServiceSize(ServiceID id, long bytes) {
    services.resize(id, bytes);
  }

  /** Records a registered listener and its size in bytes. */
  void addListener(RegistrationOrigin from, long event, long bytes) {
    listeners.put(event, from, bytes);
  }

  /** How many services and listeners are recorded, for tests. */
  int trackedCount() {
    return services.noted.size() + listeners.noted.size();
  }

  /**
   * The origins of registrations of one kind. It removes expired registrations when a limit is
   * reached, and when it has twice as many as after the last removal.
   */
  private static final class QuotaTable<K> {

    private static final int FEW = 64;

    /** The limit of the total size is the sum of the maximum sizes, divided by this. */
    private static final int SHARE = 8;

    private final String kind;
    private final int perAddress;
    private final int inAll;
    private final long bytesOfOne;
    private final UnaryOperator<Set<K>> live;
    private final Map<K, TrackedRegistration> noted = new LinkedHashMap<>();
    private int next = FEW; // size at which it removes expired ones

    private record TrackedRegistration(RegistrationOrigin source, long bytes) {}

    QuotaTable(
        String kind, int perAddress, int inAll, long bytesOfOne, UnaryOperator<Set<K>> live) {
      this.kind = kind;
      this.perAddress = perAddress;
      this.inAll = inAll;
      this.bytesOfOne = bytesOfOne;
      this.live = live;
    }

    @Nullable RegistrationOrigin source(K key) {
      @Nullable TrackedRegistration its = noted.get(key);
      return its == null ? null : its.source();
    }

    void put(K key, RegistrationOrigin from, long bytes) {
      noted.put(key, new TrackedRegistration(from, bytes));
      if (noted.size() >= next) {
        dropEnded();
      }
    }

    void resize(K key, long bytes) {
      @Nullable TrackedRegistration its = noted.get(key);
      if (its != null) {
        noted.put(key, new TrackedRegistration(its.source(), bytes));
      }
    }

    private void dropEnded() {
      Set<K> stay = live.apply(Collections.unmodifiableSet(noted.keySet()));
      boolean unused = noted.keySet().retainAll(stay);
      next = Math.max(FEW, 2 * noted.size());
    }

    /** A replacement needs only the space beyond that of the replaced one. */
    void checkBounds(RegistrationOrigin from, @Nullable K replaced, long bytes) {
      if (bytes > bytesOfOne) {
        throw new RegistrationRefusedException(
            refused(from) + bytes + " bytes > " + bytesOfOne + " allowed; register less");
      }
      if (fault(from, replaced, bytes) != null) {
        dropEnded();
        @Nullable String fault = fault(from, replaced, bytes);
        if (fault != null) {
          throw new RegistrationRefusedException(fault);
        }
      }
    }

    private String refused(RegistrationOrigin from) {
      return "one more of the " + kind + " of " + from + " is refused: ";
    }

    private @Nullable String fault(RegistrationOrigin from, @Nullable K replaced, long bytes) {
      long foreign = 0;
      long same = 0;
      long foreignBytes = bytes;
      long sameBytes = bytes;
      for (Map.Entry<K, TrackedRegistration> each : noted.entrySet()) {
        RegistrationOrigin source = each.getValue().source();
        if (!source.isRobotHost() && !each.getKey().equals(replaced)) {
          foreign++;
          foreignBytes += each.getValue().bytes();
          if (source.equals(from)) {
            same++;
            sameBytes += each.getValue().bytes();
          }
        }
      }
      long most = perAddress * bytesOfOne / SHARE;
      long mostInAll = inAll * bytesOfOne / SHARE;
      return Stream.of(
              beyond(same, perAddress - 1L, " from that address >= " + perAddress),
              beyond(foreign, inAll - 1L, " from all other computers >= " + inAll),
              beyond(sameBytes, most, " bytes from that address > " + most),
              beyond(foreignBytes, mostInAll, " bytes from all other computers > " + mostInAll))
          .flatMap(Optional::stream)
          .findFirst()
          .map(what -> refused(from) + what + " allowed; end some, or wait until their leases end")
          .orElse(null);
    }

    private static Optional<String> beyond(long count, long most, String what) {
      return count > most ? Optional.of(count + what) : Optional.empty();
    }
  }

  /**
   * The computer that a registration comes from.
   *
   * @param address its address; null if unknown
   * @param isRobotHost whether it is one of the robot's hosts
   */
  record RegistrationOrigin(@Nullable InetAddress address, boolean isRobotHost) {

    /** Whether a registration from here may replace one from another origin. */
    boolean mayReplace(RegistrationOrigin other) {
      return isRobotHost
          || (!other.isRobotHost && address != null && address.equals(other.address));
    }

    /** Its numeric address, or a substitute. */
    @Override
    public String toString() {
      return new RemoteCaller(address).toString();
    }
  }
}
