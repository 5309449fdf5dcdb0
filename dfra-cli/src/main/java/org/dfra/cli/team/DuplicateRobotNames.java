package org.dfra.cli.team;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.UUID;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.Persona;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;

/**
 * Robots of one name in a team. A host distinguishes them; two robots on one host, each with its
 * own phoenix, differ in the IDs of their modules.
 */
public final class DuplicateRobotNames {

  private DuplicateRobotNames() {}

  /**
   * The hosts for each name that more than one robot has. A host is listed twice if two of the
   * robots run on it. Stale listings are ignored: those robots may not exist any more.
   */
  public static Map<String, List<String>> of(Collection<? extends ModuleListing<?>> listings) {
    Map<String, Set<String>> hosts = new TreeMap<>();
    Map<String, Map<String, UUID>> modules = new TreeMap<>();
    Map<String, List<String>> several = new TreeMap<>();
    for (ModuleListing<?> each : listings) {
      if (!each.stale() && !each.robot().isEmpty() && !each.host().isEmpty()) {
        hosts.computeIfAbsent(each.robot(), robot -> new TreeSet<>()).add(each.host());
        UUID other =
            modules
                .computeIfAbsent(each.robot(), robot -> new TreeMap<>())
                .putIfAbsent(each.host() + "/" + each.name(), each.id());
        if (other != null && !other.equals(each.id())) {
          several.put(each.robot(), List.of(each.host(), each.host()));
        }
      }
    }
    hosts.forEach(
        (robot, names) -> {
          if (names.size() > 1) {
            several.put(robot, new ArrayList<>(names));
          }
        });
    return several;
  }

  /**
   * The displayed name of a module's robot, which commands accept: {@code robot@host} if another
   * robot of the listing has its name, else its name alone.
   */
  public static String displayName(
      ModuleListing<?> one, Collection<? extends ModuleListing<?>> listed) {
    boolean isAlone =
        one.host().isEmpty()
            || listed.stream()
                .filter(each -> each.robot().equals(one.robot()))
                .allMatch(each -> each.host().isEmpty() || each.host().equals(one.host()));
    return isAlone ? one.robot() : one.robot() + "@" + one.host();
  }

  /** A module likewise: {@code robot/module} or {@code robot@host/module}. */
  public static String displayPath(
      ModuleListing<?> one, Collection<? extends ModuleListing<?>> listed) {
    return displayName(one, listed) + "/" + one.name();
  }

  /** {@code 2 robots are named atrv1, on 10.0.0.5 and 10.0.0.6}. */
  public static String inWords(String robot, List<String> hosts) {
    return hosts.size() + " robots are named " + robot + ", on " + String.join(" and ", hosts);
  }

  /** The robot's name in {@code robot@host}, or in {@code robot}. */
  public static String name(String text) {
    int at = text.indexOf('@');
    return at < 0 ? text : text.substring(0, at);
  }

  /**
   * Whether a module is at the place in {@code robot@host}; always true for {@code robot} alone.
   */
  public static boolean isAtPlace(String text, ModuleListing<?> module) {
    int at = text.indexOf('@');
    return at < 0 || module.host().equals(text.substring(at + 1));
  }

  /**
   * Modules of one robot.
   *
   * @param text the robot's name, or {@code robot@host} if several have it
   * @param search finds the modules of the robots of a name
   * @throws CommandFailure if they belong to more than one robot
   */
  public static <M extends Module> List<ModuleListing<M>> choose(
      String text, Function<String, List<ModuleListing<M>>> search) {
    String robot = name(text);
    List<ModuleListing<M>> found =
        search.apply(robot).stream().filter(each -> isAtPlace(text, each)).toList();
    List<String> hosts =
        found.stream()
            .filter(each -> !each.stale())
            .map(ModuleListing::host)
            .distinct()
            .sorted()
            .toList();
    requireOne(robot, hosts);
    return found;
  }

  /**
   * One robot of the team.
   *
   * @param text the robot's name, or {@code robot@host} if several have it
   * @return empty if there is no such robot
   * @throws CommandFailure if several currently listed robots have it
   */
  public static Optional<Persona> choose(String text, List<Persona> team) {
    int at = text.indexOf('@');
    String robot = at < 0 ? text : text.substring(0, at);
    List<Persona> found =
        team.stream()
            .filter(each -> each.robot().equals(robot))
            .filter(each -> at < 0 || each.host().equals(text.substring(at + 1)))
            .sorted(Comparator.comparing(Persona::stale))
            .toList();
    requireOne(
        robot, found.stream().filter(each -> !each.stale()).map(Persona::host).sorted().toList());
    return found.stream().findFirst();
  }

  private static void requireOne(String robot, List<String> hosts) {
    if (hosts.size() > 1) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          inWords(robot, hosts)
              + "; name one of "
              + hosts.stream().map(host -> robot + "@" + host).collect(Collectors.joining(", ")));
    }
  }
}
