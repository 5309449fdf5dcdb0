package org.dfra.core.directory;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.persona.PersonaAttributes;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Groups the entries of a directory by robot. The host distinguishes robots of the same name. An
 * entry without a host belongs to the robot of its name; if several robots have that name, it is
 * omitted until its host is known.
 */
final class PersonaGrouper {

  /** Entries without a host do not form a separate robot if a robot of the name is known. */
  private static final String UNKNOWN = "";

  private final SortedMap<String, SortedMap<String, Draft>> robots = new TreeMap<>();

  private PersonaGrouper() {}

  /**
   * The robots, by name and host.
   *
   * @param signs the entries that represent a robot but are not modules
   */
  static List<Persona> of(
      Collection<ModuleTable.RobotEntry> signs, Collection<ModuleListing<Module>> modules) {
    PersonaGrouper personas = new PersonaGrouper();
    for (ModuleListing<Module> each : modules) {
      if (!each.robot().isEmpty()) {
        personas.at(each.robot(), each.host()).add(each);
      }
    }
    for (ModuleTable.RobotEntry each : signs) { // with the name in its modules' listings
      personas.at(PrintableText.word(each.attributes().robot()), each.host()).add(each);
    }
    List<Persona> all = new ArrayList<>();
    personas.robots.forEach((name, hosts) -> all.addAll(named(name, hosts)));
    return all;
  }

  private Draft at(String robot, String host) {
    return robots
        .computeIfAbsent(robot, name -> new TreeMap<>())
        .computeIfAbsent(host, place -> new Draft());
  }

  /** The robots with one name. */
  private static List<Persona> named(String name, SortedMap<String, Draft> hosts) {
    @Nullable Draft anywhere = hosts.size() > 1 ? hosts.remove(UNKNOWN) : null;
    if (anywhere != null && hosts.size() == 1) {
      hosts.values().iterator().next().add(anywhere);
    }
    List<Persona> all = new ArrayList<>();
    for (Map.Entry<String, Draft> each : hosts.entrySet()) {
      all.add(each.getValue().persona(name, each.getKey()));
    }
    return all;
  }

  /** A persona under construction. */
  private static final class Draft {
    private @Nullable PersonaAttributes attributes;
    private final List<ModuleListing<Module>> modules = new ArrayList<>();
    private boolean stale = true;
    private Instant confirmed = Instant.MIN;

    void add(ModuleListing<Module> module) {
      modules.add(module);
      see(module.stale(), module.confirmed());
    }

    void add(ModuleTable.RobotEntry sign) {
      attributes = sign.attributes();
      see(sign.stale(), sign.confirmed());
    }

    void add(Draft other) {
      modules.addAll(other.modules);
      if (attributes == null) {
        attributes = other.attributes;
      }
      see(other.stale, other.confirmed);
    }

    private void see(boolean isStale, Instant when) {
      if (stale && !isStale) {
        confirmed = when;
      } else if (stale == isStale && when.isAfter(confirmed)) {
        confirmed = when;
      }
      stale &= isStale;
    }

    Persona persona(String robot, String host) {
      modules.sort(Comparator.comparing(ModuleListing<Module>::name));
      return new Persona(robot, host, Optional.ofNullable(attributes), modules, stale, confirmed);
    }
  }
}
