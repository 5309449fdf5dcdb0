package org.dfra.core.directory;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The data of a directory: modules by identity, and entries for robots without a module.
 * Thread-safe; a reader sees a consistent snapshot of each module.
 */
public final class ModuleTable {

  private final InstantSource clock;
  private final Map<UUID, ModuleListing<Module>> modules = new ConcurrentHashMap<>();
  private final Map<UUID, RobotEntry> robots = new ConcurrentHashMap<>();
  private final List<Consumer<UUID>> observers = new CopyOnWriteArrayList<>();

  @GuardedBy("this")
  private final Set<UUID> unsorted = new HashSet<>();

  private volatile @Nullable List<ModuleListing<Module>> sorted = List.of(); // null: to be sorted

  @GuardedBy("this")
  private List<ModuleListing<Module>> lastSorted = List.of();

  private volatile long version; // written with the lock of this held
  private volatile Places places = new Places(-1, Map.of());

  /**
   * An entry that represents a robot but is not a module: its registrar.
   *
   * @param host address or name of the computer it runs on; empty if unknown
   */
  record RobotEntry(PersonaAttributes attributes, String host, boolean stale, Instant confirmed) {}

  /** A robot, distinguished from others of the same name by its host. */
  private record RobotAt(String name, String host) {}

  /** The position of each robot, as of a version of the table. */
  private record Places(long version, Map<RobotAt, LocationAttributes> robots) {}

  ModuleTable(InstantSource clock) {
    this.clock = clock;
  }

  /** Changes with every change of the table. */
  long version() {
    return version;
  }

  /**
   * Adds an observer that receives the identity of each changed entry, on the thread that makes the
   * change.
   */
  void addObserver(Consumer<UUID> observer) {
    observers.add(observer);
  }

  void removeObserver(Consumer<UUID> observer) {
    observers.remove(observer);
  }

  /**
   * Adds or updates a module that a lookup service lists.
   *
   * @param module the module, or its proxy
   * @param attributes its published attributes
   */
  public void put(UUID id, Module module, List<Attributes> attributes, Locality locality) {
    boolean news;
    synchronized (this) {
      @Nullable ModuleListing<Module> old = modules.get(id);
      news =
          old == null
              || old.stale()
              || old.locality() != locality
              || old.module().getClass() != module.getClass()
              || !old.attributes().equals(attributes);
      if (!news && old != null && old.module() == module) {
        return;
      }
      Optional<ModuleAttributes> named =
          attributes.stream()
              .filter(ModuleAttributes.class::isInstance)
              .map(ModuleAttributes.class::cast)
              .findFirst();
      modules.put(
          id,
          new ModuleListing<>(
              id,
              module,
              named.map(ModuleAttributes::robot).orElse(""),
              named.map(ModuleAttributes::name).orElse(""),
              attributes,
              locality,
              false,
              news || old == null ? clock.instant() : old.confirmed()));
      changed(id);
    }
    if (news) {
      notifyObservers(id);
    }
  }

  /**
   * Adds or updates a robot without a module that a lookup service lists.
   *
   * @param host address or name of the computer it runs on; empty if unknown
   */
  public void put(UUID id, PersonaAttributes robot, String host) {
    synchronized (this) {
      @Nullable RobotEntry old = robots.get(id);
      if (old != null
          && !old.stale()
          && old.attributes().equals(robot)
          && old.host().equals(host)) {
        return;
      }
      robots.put(id, new RobotEntry(robot, host, false, clock.instant()));
      changed(id);
    }
    notifyObservers(id);
  }

  /**
   * Sets the host of a robot's entry. Does nothing if there is no entry.
   *
   * @param host address or name of the computer
   */
  public void setHost(UUID id, String host) {
    synchronized (this) {
      @Nullable RobotEntry old = robots.get(id);
      if (old == null || old.host().equals(host)) {
        return;
      }
      robots.put(id, new RobotEntry(old.attributes(), host, old.stale(), old.confirmed()));
      changed(id);
    }
    notifyObservers(id);
  }

  /**
   * Marks an entry stale: no reachable lookup service lists it, but it was not removed.
   *
   * @param vouched when a lookup service last listed it
   */
  public void markStale(UUID id, Instant vouched) {
    synchronized (this) {
      @Nullable ModuleListing<Module> old = modules.get(id);
      @Nullable RobotEntry sign = robots.get(id);
      if ((old == null || old.stale()) && (sign == null || sign.stale())) {
        return;
      }
      if (old != null) {
        modules.put(id, old.asStale(vouched));
      }
      if (sign != null) {
        robots.put(id, new RobotEntry(sign.attributes(), sign.host(), true, vouched));
      }
      changed(id);
    }
    notifyObservers(id);
  }

  /** Removes an entry. */
  public void remove(UUID id) {
    synchronized (this) {
      boolean module = modules.remove(id) != null;
      boolean robot = robots.remove(id) != null;
      if (!module && !robot) {
        return;
      }
      changed(id);
    }
    notifyObservers(id);
  }

  void clear() {
    synchronized (this) {
      modules.clear();
      robots.clear();
      unsorted.clear();
      lastSorted = List.of();
      sorted = lastSorted;
      version++;
    }
  }

  @Nullable ModuleListing<Module> get(UUID id) {
    return modules.get(id);
  }

  /** Every module, unordered and weakly consistent. */
  Iterable<ModuleListing<Module>> unordered() {
    return modules.values();
  }

  /** A consistent snapshot of every module, the best first. */
  List<ModuleListing<Module>> all() {
    @Nullable List<ModuleListing<Module>> ready = sorted;
    return ready != null ? ready : sort();
  }

  /** Merges the changes since the last call into the sorted list. */
  private synchronized List<ModuleListing<Module>> sort() {
    @Nullable List<ModuleListing<Module>> ready = sorted;
    if (ready != null) {
      return ready;
    }
    List<ModuleListing<Module>> next = new ArrayList<>(modules.size());
    for (ModuleListing<Module> each : lastSorted) {
      if (!unsorted.contains(each.id())) {
        next.add(each);
      }
    }
    for (UUID id : unsorted) {
      @Nullable ModuleListing<Module> now = modules.get(id);
      if (now != null) {
        next.add(now);
      }
    }
    unsorted.clear();
    next.sort(CachedModuleDirectory.BEST_FIRST); // nearly sorted input is fast
    lastSorted = next;
    sorted = next;
    return next;
  }

  /** Called with the lock held. */
  @GuardedBy("this")
  private void changed(UUID id) {
    unsorted.add(id);
    sorted = null;
    version++;
  }

  List<RobotEntry> robots() {
    return new ArrayList<>(robots.values());
  }

  /** The position of a module's robot: the newest of the positions of the robot's modules. */
  Optional<GeoPosition> robotPosition(ModuleListing<?> module) {
    Places known = places;
    long now = version;
    if (known.version() != now) {
      Map<RobotAt, LocationAttributes> newest = new HashMap<>();
      for (ModuleListing<Module> each : modules.values()) {
        each.attributes(LocationAttributes.class)
            .ifPresent(
                location ->
                    newest.merge(
                        new RobotAt(each.robot(), each.host()),
                        location,
                        (a, b) -> a.measured().isBefore(b.measured()) ? b : a));
      }
      known = new Places(now, newest);
      places = known;
    }
    return Optional.ofNullable(known.robots().get(new RobotAt(module.robot(), module.host())))
        .map(LocationAttributes::position);
  }

  private void notifyObservers(UUID id) {
    observers.forEach(observer -> observer.accept(id));
  }
}
