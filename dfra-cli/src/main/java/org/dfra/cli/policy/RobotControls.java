package org.dfra.cli.policy;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.robot.PolicyControl;
import org.dfra.river.security.robot.PolicyControls;
import org.jspecify.annotations.Nullable;

/** The robots' processes to which operators speak about the policy. */
final class RobotControls {

  private static final ModuleQuery<Module> ANY = ModuleQuery.of(Module.class);

  private RobotControls() {}

  /**
   * What a robot is asked.
   *
   * @param <T> its answer
   */
  @FunctionalInterface
  interface Question<T> {
    T ask(PolicyControl control) throws IOException;
  }

  /**
   * Fails if this computer is no member of a team, whose robots have no policy.
   *
   * @throws CommandFailure if so
   */
  static void requireMember() {
    if (SecureProcess.current().mode() == SecurityMode.OPEN) {
      throw new CommandFailure(
          ExitCode.FAILED,
          "this computer has joined no team, and open robots have no policy; join one: "
              + CommandName.current()
              + " security join NAME.bundle");
    }
  }

  /** The names of the robots that are found, in alphabetical order. */
  static List<String> robots(TeamDirectory team) throws InterruptedException {
    return team.awaitDirectory().find(ANY).stream()
        .map(ModuleListing::robot)
        .filter(each -> !each.isEmpty())
        .distinct()
        .sorted()
        .toList();
  }

  /**
   * Asks one of a robot's processes after the other until one answers: each knows the same.
   *
   * @param robot name, as {@link DuplicateRobotNames#choose} takes it
   * @throws CommandFailure if the robot is not found
   * @throws IOException if none answers
   */
  static <T> T ask(TeamDirectory team, String robot, Question<T> question)
      throws IOException, InterruptedException {
    String name = DuplicateRobotNames.name(robot);
    @Nullable RemoteException failure = null;
    for (PeerAddress each : processes(team, robot)) {
      try {
        return question.ask(PolicyControls.of(name, each));
      } catch (RemoteException e) {
        failure = e;
      }
    }
    if (failure != null) {
      throw failure;
    }
    throw new CommandFailure(
        ExitCode.NOT_FOUND,
        "robot "
            + robot
            + " is not there; "
            + CommandName.current()
            + " persona list shows the robots");
  }

  private static Set<PeerAddress> processes(TeamDirectory team, String robot)
      throws InterruptedException {
    ModuleQuery<Module> query = ANY.robot(DuplicateRobotNames.name(robot));
    List<ModuleListing<Module>> unused =
        team.await(query, each -> DuplicateRobotNames.isAtPlace(robot, each));
    ModuleDirectory directory = team.awaitDirectory();
    Set<PeerAddress> processes = new LinkedHashSet<>();
    for (ModuleListing<Module> each :
        DuplicateRobotNames.choose(robot, name -> directory.find(ANY.robot(name)))) {
      if (each.module() instanceof ModuleProxy<?> proxy) {
        @Nullable PeerAddress address = PeerAddress.of(proxy.server());
        if (address != null) {
          processes.add(address);
        }
      }
    }
    return processes;
  }
}
