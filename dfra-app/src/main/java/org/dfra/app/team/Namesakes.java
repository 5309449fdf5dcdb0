package org.dfra.app.team;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.UUID;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;

/**
 * Robots of one name in a team. A robot differs from its namesakes by its host; two on one host,
 * each with a phoenix of its own, by the identities of their modules.
 */
public final class Namesakes {

  private Namesakes() {}

  /** Where a module runs, as its entries say; empty where they do not. */
  public static String host(ModuleListing<?> listing) {
    return listing.attributes(ModuleAttributes.class).map(ModuleAttributes::host).orElse("");
  }

  /**
   * The hosts of each name that more than one robot has. A host is there twice where two of the
   * robots are on it. What no lookup service vouches for does not count: it may be gone.
   */
  public static Map<String, List<String>> of(Collection<? extends ModuleListing<?>> listings) {
    Map<String, Set<String>> hosts = new TreeMap<>();
    Map<String, Map<String, UUID>> modules = new TreeMap<>();
    Map<String, List<String>> several = new TreeMap<>();
    for (ModuleListing<?> each : listings) {
      if (!each.stale() && !each.robot().isEmpty() && !host(each).isEmpty()) {
        hosts.computeIfAbsent(each.robot(), robot -> new TreeSet<>()).add(host(each));
        UUID other =
            modules
                .computeIfAbsent(each.robot(), robot -> new TreeMap<>())
                .putIfAbsent(host(each) + "/" + each.name(), each.id());
        if (other != null && !other.equals(each.id())) {
          several.put(each.robot(), List.of(host(each), host(each)));
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

  /** {@code 2 robots are named atrv1, on 10.0.0.5 and 10.0.0.6}. */
  public static String inWords(String robot, List<String> hosts) {
    return hosts.size() + " robots are named " + robot + ", on " + String.join(" and ", hosts);
  }

  /** The robot's name in {@code robot@host}, or in {@code robot}. */
  static String name(String text) {
    int at = text.indexOf('@');
    return at < 0 ? text : text.substring(0, at);
  }

  /** Whether a module is where {@code robot@host} says; {@code robot} alone says nothing. */
  static boolean isAtPlace(String text, ModuleListing<?> module) {
    int at = text.indexOf('@');
    return at < 0 || host(module).equals(text.substring(at + 1));
  }

  /**
   * Modules of one robot.
   *
   * @param text the robot's name, or {@code robot@host} where several have it
   * @param search finds the modules of the robots of a name
   * @throws CommandFailure if they are of more than one robot
   */
  public static <M extends Module> List<ModuleListing<M>> choose(
      String text, Function<String, List<ModuleListing<M>>> search) {
    String robot = name(text);
    List<ModuleListing<M>> found =
        search.apply(robot).stream().filter(each -> isAtPlace(text, each)).toList();
    List<String> hosts =
        found.stream()
            .filter(each -> !each.stale())
            .map(Namesakes::host)
            .distinct()
            .sorted()
            .toList();
    if (hosts.size() > 1) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          inWords(robot, hosts)
              + "; name one of "
              + hosts.stream().map(host -> robot + "@" + host).collect(Collectors.joining(", ")));
    }
    return found;
  }
}
