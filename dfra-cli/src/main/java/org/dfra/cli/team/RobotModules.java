package org.dfra.cli.team;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;

/** The single module of a kind of each robot that a user names. */
public final class RobotModules {

  private RobotModules() {}

  /**
   * Finds them; waits for missing ones until the command's timeout.
   *
   * @param any all of the kind
   * @param robots names, as {@link DuplicateRobotNames#choose} takes them; all robots if empty
   * @param kind as text, e.g. {@code recruitment agent}
   * @param remedy what to enter if no robot has one, e.g. {@code ./dfra persona list shows the
   *     robots}
   * @return in the order of the names; by path if there are none
   * @throws CommandFailure if there is none, or a named robot has none
   */
  public static <M extends Module> List<ModuleListing<M>> of(
      TeamDirectory team, ModuleQuery<M> any, List<String> robots, String kind, String remedy)
      throws InterruptedException {
    ModuleDirectory directory = team.awaitDirectory();
    List<ModuleListing<M>> found = new ArrayList<>();
    for (String robot : robots) {
      List<ModuleListing<M>> unused =
          team.await(
              any.robot(DuplicateRobotNames.name(robot)),
              each -> DuplicateRobotNames.isAtPlace(robot, each));
      found.add(
          DuplicateRobotNames.choose(robot, name -> directory.find(any.robot(name))).stream()
              .findFirst()
              .orElseThrow(() -> hasNone(robot, kind)));
    }
    if (robots.isEmpty()) {
      found.addAll(team.await(any, each -> true));
      found.sort(Comparator.comparing(ModuleListing::path));
      if (found.isEmpty()) {
        throw new CommandFailure(
            ExitCode.NOT_FOUND,
            "no robot that answers has a "
                + kind
                + "; "
                + remedy
                + ", or wait longer for answers: --wait 10");
      }
    }
    return found;
  }

  private static CommandFailure hasNone(String robot, String kind) {
    return new CommandFailure(
        ExitCode.NOT_FOUND,
        "robot "
            + robot
            + " has no "
            + kind
            + ", or is not there; "
            + CommandName.current()
            + " persona list shows the robots");
  }
}
