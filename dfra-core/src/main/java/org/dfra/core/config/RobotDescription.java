package org.dfra.core.config;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.dfra.persona.PersonaAttributes;

/**
 * One robot, as its XML describes it, with every variable substituted.
 *
 * @param name name of the robot, in lower_snake_case
 * @param host address or host name in the robot's proxies; {@code auto} to select an interface
 * @param lookupGroups discovery groups whose registrars the robot's modules join; none if empty
 * @param locators registrars joined by unicast, each as {@code jini://host} or {@code
 *     jini://host:port}
 * @param administration the hosts that may administer it besides its own computer
 * @param persona the robot's role, goals and limitations, if configured
 * @param groups the service groups, at least one; at most one of them hosts the registrar
 * @param source the file that was read
 */
public record RobotDescription(
    String name,
    String host,
    List<String> lookupGroups,
    List<String> locators,
    RobotDescription.AdministrationDescription administration,
    Optional<PersonaAttributes> persona,
    List<RobotDescription.GroupDescription> groups,
    Path source) {

  public RobotDescription {
    SourceLocation whole = new SourceLocation(source.toString(), 0);
    DescriptionRules.require(whole, DescriptionRules.name("robot", name));
    DescriptionRules.require(whole, DescriptionRules.host(host));
    lookupGroups.forEach(
        group -> DescriptionRules.require(whole, DescriptionRules.lookupGroup(group)));
    locators.forEach(locator -> DescriptionRules.require(whole, DescriptionRules.locator(locator)));
    lookupGroups = List.copyOf(lookupGroups);
    locators =
        locators.stream()
            .map(text -> DescriptionRules.canonicalLocator(text).orElseThrow())
            .toList();
    groups = List.copyOf(groups);
    if (groups.isEmpty()) {
      throw new ConfigurationException(
          whole + ": robot " + name + " has no group; add one, since a group runs its modules");
    }
    requireUnique("group", groups.stream(), GroupDescription::name, GroupDescription::place);
    requireUnique(
        "module", modules(groups).stream(), ModuleDescription::name, ModuleDescription::place);
    for (ModuleDescription module : modules(groups)) {
      if (!module.robot().equals(name)) {
        throw new ConfigurationException(
            module.place()
                + ": module "
                + module.path()
                + " is not of robot "
                + name
                + "; give it that robot");
      }
    }
    if (groups.stream().filter(group -> group.registrar().isPresent()).count() > 1) {
      throw new ConfigurationException(
          whole + ": robot " + name + " has more than one registrar; leave it in one group only");
    }
  }

  /** A robot that is administered from its own computer only. */
  public RobotDescription(
      String name,
      String host,
      List<String> lookupGroups,
      List<String> locators,
      Optional<PersonaAttributes> persona,
      List<GroupDescription> groups,
      Path source) {
    this(
        name,
        host,
        lookupGroups,
        locators,
        AdministrationDescription.LOCAL,
        persona,
        groups,
        source);
  }

  /** The same, without a configured persona. */
  public RobotDescription(
      String name,
      String host,
      List<String> lookupGroups,
      List<String> locators,
      List<GroupDescription> groups,
      Path source) {
    this(name, host, lookupGroups, locators, Optional.empty(), groups, source);
  }

  /**
   * A copy whose modules join only these registrars by unicast, as those of a team do without
   * multicast.
   *
   * @param registrars each as {@code jini://host:port}
   */
  public RobotDescription withRegistrars(List<String> registrars) {
    return new RobotDescription(
        name, host, lookupGroups, registrars, administration, persona, groups, source);
  }

  /** A copy whose modules join only lookup services that serve these groups by multicast. */
  public RobotDescription withLookupGroups(List<String> others) {
    return new RobotDescription(
        name, host, others, locators, administration, persona, groups, source);
  }

  /** A copy with other groups. */
  public RobotDescription withGroups(List<GroupDescription> others) {
    return new RobotDescription(
        name, host, lookupGroups, locators, administration, persona, others, source);
  }

  /** The robot's own lookup service, if one of its groups hosts it. */
  public Optional<RegistrarDescription> registrar() {
    return groups.stream().flatMap(group -> group.registrar().stream()).findFirst();
  }

  /** The modules of all groups, in file order. */
  public List<ModuleDescription> modules() {
    return modules(groups);
  }

  private static List<ModuleDescription> modules(List<GroupDescription> groups) {
    return groups.stream().flatMap(group -> group.modules().stream()).toList();
  }

  private static <T> void requireUnique(
      String what, Stream<T> things, Function<T, String> name, Function<T, SourceLocation> place) {
    Set<String> seen = new HashSet<>();
    things.forEach(
        thing -> {
          if (!seen.add(name.apply(thing))) {
            throw new ConfigurationException(
                place.apply(thing)
                    + ": there is a second "
                    + what
                    + " "
                    + name.apply(thing)
                    + "; rename or delete one");
          }
        });
  }

  /**
   * The hosts that may administer a robot besides its own computer.
   *
   * @param administratorHosts addresses, ranges as {@code 10.0.0.0/24}, and host names, which are
   *     not resolved here; empty for the robot's own computer only
   * @param place its place in the configuration
   */
  public record AdministrationDescription(List<String> administratorHosts, SourceLocation place) {

    /** The robot's own computer only. */
    public static final AdministrationDescription LOCAL =
        new AdministrationDescription(List.of(), SourceLocation.CODE);

    public AdministrationDescription {
      administratorHosts = List.copyOf(administratorHosts);
      for (String each : administratorHosts) {
        DescriptionRules.require(place, DescriptionRules.administrator(each));
      }
    }
  }

  /**
   * One service group: the modules that share one JVM, and fail together when it fails.
   *
   * @param name name of the group, unique on its robot, in lower_snake_case
   * @param jvmOptions options of the group's JVM, in the order written, e.g. {@code -Xmx64m}
   * @param registrar the robot's own lookup service, if this group hosts it
   * @param modules the group's modules, in the order written
   * @param place its place in the configuration
   */
  public record GroupDescription(
      String name,
      List<String> jvmOptions,
      Optional<RegistrarDescription> registrar,
      List<ModuleDescription> modules,
      SourceLocation place) {

    public GroupDescription {
      jvmOptions = jvmOptions.stream().map(String::strip).toList();
      modules = List.copyOf(modules);
      DescriptionRules.require(place, DescriptionRules.name("group", name));
      if (jvmOptions.stream().anyMatch(String::isEmpty)) {
        throw new ConfigurationException(
            place + ": group " + name + " has an empty JVM option; write one or leave it out");
      }
    }
  }
}
