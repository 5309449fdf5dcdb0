package org.dfra.core.directory;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
 * What a directory knows: modules by identity, and what stands for a robot as such. Safe for many
 * threads; whoever reads sees each module as it was at one moment.
 */
public final class ModuleTable {

  private final InstantSource clock;
  private final Map<UUID, ModuleListing<Module>> modules = new ConcurrentHashMap<>();
  private final Map<UUID, RobotSign> robots = new ConcurrentHashMap<>();
  private final List<Consumer<UUID>> observers = new CopyOnWriteArrayList<>();
  private volatile long version; // written under this
  private volatile Places places = new Places(-1, Map.of());

  /** Something that shows a robot but is no module: its registrar. */
  record RobotSign(PersonaAttributes attributes, boolean stale, Instant confirmed) {}

  /** Where each robot is, as of a version of the table. */
  private record Places(long version, Map<String, LocationAttributes> robots) {}

  ModuleTable(InstantSource clock) {
    this.clock = clock;
  }

  /** Changes whenever anything here does. */
  long version() {
    return version;
  }

  /** Tells of each change, on the changer's thread: which identity it is about. */
  void observe(Consumer<UUID> observer) {
    observers.add(observer);
  }

  void forget(Consumer<UUID> observer) {
    observers.remove(observer);
  }

  /**
   * Somebody vouches for a module.
   *
   * @param module the module, or its proxy
   * @param attributes what it says of itself
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
      Optional<ModuleAttributes> who =
          attributes.stream()
              .filter(ModuleAttributes.class::isInstance)
              .map(ModuleAttributes.class::cast)
              .findFirst();
      modules.put(
          id,
          new ModuleListing<>(
              id,
              module,
              who.map(ModuleAttributes::robot).orElse(""),
              who.map(ModuleAttributes::name).orElse(""),
              attributes,
              locality,
              false,
              news || old == null ? clock.instant() : old.confirmed()));
      version++;
    }
    if (news) {
      tell(id);
    }
  }

  /** Somebody vouches for a robot as such. */
  public void put(UUID id, PersonaAttributes robot) {
    synchronized (this) {
      @Nullable RobotSign old = robots.get(id);
      if (old != null && !old.stale() && old.attributes().equals(robot)) {
        return;
      }
      robots.put(id, new RobotSign(robot, false, clock.instant()));
      version++;
    }
    tell(id);
  }

  /**
   * Nobody vouches for it any more, but nobody said that it is gone.
   *
   * @param vouched when somebody last did
   */
  public void stale(UUID id, Instant vouched) {
    synchronized (this) {
      @Nullable ModuleListing<Module> old = modules.get(id);
      @Nullable RobotSign sign = robots.get(id);
      if ((old == null || old.stale()) && (sign == null || sign.stale())) {
        return;
      }
      if (old != null) {
        modules.put(
            id,
            new ModuleListing<>(
                id,
                old.module(),
                old.robot(),
                old.name(),
                old.attributes(),
                old.locality(),
                true,
                vouched));
      }
      if (sign != null) {
        robots.put(id, new RobotSign(sign.attributes(), true, vouched));
      }
      version++;
    }
    tell(id);
  }

  /** It is gone. */
  public void remove(UUID id) {
    synchronized (this) {
      boolean module = modules.remove(id) != null;
      boolean robot = robots.remove(id) != null;
      if (!module && !robot) {
        return;
      }
      version++;
    }
    tell(id);
  }

  void clear() {
    synchronized (this) {
      modules.clear();
      robots.clear();
      version++;
    }
  }

  @Nullable ModuleListing<Module> get(UUID id) {
    return modules.get(id);
  }

  Iterable<ModuleListing<Module>> all() {
    return modules.values();
  }

  List<RobotSign> robots() {
    return new ArrayList<>(robots.values());
  }

  /** Where a robot is, by the newest of its modules' locations. */
  Optional<GeoPosition> place(String robot) {
    Places known = places;
    long now = version;
    if (known.version() != now) {
      Map<String, LocationAttributes> newest = new HashMap<>();
      for (ModuleListing<Module> each : modules.values()) {
        each.attributes(LocationAttributes.class)
            .ifPresent(
                location ->
                    newest.merge(
                        each.robot(),
                        location,
                        (a, b) -> a.measured().isBefore(b.measured()) ? b : a));
      }
      known = new Places(now, newest);
      places = known;
    }
    return Optional.ofNullable(known.robots().get(robot)).map(LocationAttributes::position);
  }

  private void tell(UUID id) {
    observers.forEach(observer -> observer.accept(id));
  }
}
