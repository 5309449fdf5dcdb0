package org.dfra.cli.team;

import java.util.List;
import java.util.stream.Collectors;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;

/**
 * A module's name in commands: {@code module}, {@code robot/module}, or {@code robot@host/module}
 * if several robots have that name. In place of the host, a prefix of the module's service ID
 * distinguishes two on one host.
 *
 * @param text the argument
 * @param robot name of the robot; null if not given
 * @param place host, or a prefix of a service ID; null if not given
 * @param module name of the module
 */
record ModuleName(String text, @Nullable String robot, @Nullable String place, String module) {

  /** Length of a service ID's prefix that is distinct in practice. */
  private static final int ID_LENGTH = 8;

  static ModuleName of(String text) {
    int slash = text.lastIndexOf('/');
    if (slash < 0) {
      return new ModuleName(text, null, null, text);
    }
    String robot = text.substring(0, slash);
    int at = robot.indexOf('@');
    return new ModuleName(
        text,
        at < 0 ? robot : robot.substring(0, at),
        at < 0 ? null : robot.substring(at + 1),
        text.substring(slash + 1));
  }

  /** Whether a robot's module has these names, on any host. */
  boolean isOf(String ofRobot, String ofModule) {
    return module.equals(ofModule) && (robot == null || robot.equals(ofRobot));
  }

  /** The query for it, on any host. */
  ModuleQuery<Module> query() {
    ModuleQuery<Module> named = ModuleQuery.of(Module.class).name(module);
    return robot == null ? named : named.robot(robot);
  }

  /** The found modules at the given place; all if none is given. */
  List<ModuleListing<Module>> at(List<ModuleListing<Module>> found) {
    @Nullable String wanted = place;
    return wanted == null
        ? found
        : found.stream()
            .filter(
                each ->
                    each.host().equals(wanted)
                        || (wanted.length() >= ID_LENGTH
                            && each.id().toString().startsWith(wanted)))
            .toList();
  }

  /**
   * The selected module. Stale listings count only if there is no current one.
   *
   * @param found all that have the names, at least one of which is at the given place
   * @throws CommandFailure if it is ambiguous
   */
  ModuleListing<Module> choose(List<ModuleListing<Module>> found) {
    List<ModuleListing<Module>> here = at(found);
    List<ModuleListing<Module>> living = here.stream().filter(each -> !each.stale()).toList();
    List<ModuleListing<Module>> meant = living.isEmpty() ? here : living;
    if (meant.size() == 1) {
      return meant.get(0);
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        "there are several modules "
            + text
            + "; name one of "
            + meant.stream()
                .map(each -> fullName(each, meant))
                .sorted()
                .collect(Collectors.joining(", ")));
  }

  /** The shortest name that distinguishes it from the others. */
  private static String fullName(
      ModuleListing<Module> listing, List<ModuleListing<Module>> others) {
    boolean isAlone =
        others.stream().filter(each -> each.path().equals(listing.path())).count() == 1;
    if (isAlone) {
      return listing.path();
    }
    String host = listing.host();
    boolean isAloneThere =
        !host.isEmpty()
            && others.stream()
                    .filter(each -> each.path().equals(listing.path()))
                    .filter(each -> each.host().equals(host))
                    .count()
                == 1;
    String place = isAloneThere ? host : listing.id().toString().substring(0, ID_LENGTH);
    return listing.robot() + "@" + place + "/" + listing.name();
  }
}
