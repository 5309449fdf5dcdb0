package org.dfra.core.directory;

import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import org.dfra.core.module.ModuleImpl;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.Locality;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.time.Scheduler;

/** The directory of one robot in one virtual machine, without any network. */
public final class InMemoryModuleDirectory extends CachedModuleDirectory {

  private final InstantSource clock;
  private final Scheduler scheduler;

  /** A directory on the system clock. */
  public InMemoryModuleDirectory() {
    this(InstantSource.system());
  }

  /**
   * @param clock the clock; a simulated clock if the robot is simulated. In lock-step it is the
   *     scheduler too, and all tasks of the directory run on it
   */
  public InMemoryModuleDirectory(InstantSource clock) {
    this(clock, clock instanceof Scheduler scheduler ? scheduler : Scheduler.system());
  }

  private InMemoryModuleDirectory(InstantSource clock, Scheduler scheduler) {
    super(clock, scheduler);
    this.clock = clock;
    this.scheduler = scheduler;
  }

  /**
   * Lists a module of this virtual machine, and keeps its attributes up to date.
   *
   * @return its registration; closing it removes the module
   * @throws IllegalArgumentException if another module of that robot has its name
   */
  public DirectoryRegistration add(ModuleImpl module) {
    SelfDescription self =
        new SelfDescription(module, "localhost", clock.instant(), clock.instant(), () -> 0);
    UUID id = UUID.randomUUID();
    List<Attributes> now = self.attributes();
    put(id, module, now, Locality.SAME_VM);
    AttributeMonitor follower =
        AttributeMonitor.start(
            now, self::attributes, news -> put(id, module, news, Locality.SAME_VM), scheduler);
    return () -> {
      follower.close();
      remove(id);
    };
  }

  /**
   * Lists a module, or updates its listing.
   *
   * @throws IllegalArgumentException if another module of that robot on that host has its name
   */
  public void put(UUID id, Module module, List<Attributes> attributes, Locality locality) {
    for (Attributes each : attributes) {
      if (each instanceof ModuleAttributes named) {
        table()
            .unordered()
            .forEach(
                other -> {
                  if (!other.id().equals(id)
                      && other.name().equals(named.name())
                      && other.robot().equals(named.robot())
                      && other.host().equals(named.host())) {
                    throw new IllegalArgumentException(
                        "there is a module "
                            + named.path()
                            + " already; rename or remove one of the two");
                  }
                });
      }
    }
    table().put(id, module, attributes, locality);
  }

  /** Lists a robot without a module. */
  public void put(UUID id, PersonaAttributes robot) {
    put(id, robot, "");
  }

  /**
   * Lists a robot without a module.
   *
   * @param host address or name of the computer it runs on; empty if unknown
   */
  public void put(UUID id, PersonaAttributes robot, String host) {
    table().put(id, robot, host);
  }

  /** Marks it stale from now on. */
  public void markStale(UUID id) {
    table().markStale(id, clock.instant());
  }

  /** Removes it. */
  public void remove(UUID id) {
    table().remove(id);
  }
}
