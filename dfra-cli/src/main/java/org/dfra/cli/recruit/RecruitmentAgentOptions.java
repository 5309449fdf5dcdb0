package org.dfra.cli.recruit;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.agent.RecruitmentControl;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.RobotModules;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.cli.team.UnansweredCall;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Mixin;

/** The recruitment agents of a team, and where they are discovered. A picocli mix-in. */
final class RecruitmentAgentOptions {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  /** A request to each agent. */
  @FunctionalInterface
  interface Request {
    void apply(RecruitmentControl agent) throws RemoteException;
  }

  /**
   * Sends the request to the agents of these robots, or of all, then prints their states.
   *
   * @param wanted robots; all if empty
   * @return the answers
   * @throws CommandFailure if there is none, or a named one was not found
   */
  AgentViews ask(List<String> wanted, Request request) throws IOException, InterruptedException {
    List<AgentView> views = new ArrayList<>();
    boolean isComplete = true;
    try (TeamDirectory team = options.open()) {
      List<ModuleListing<RecruitmentControl>> agents = in(team, wanted);
      for (ModuleListing<RecruitmentControl> each : agents) {
        try {
          request.apply(each.module());
          views.add(AgentView.of(DuplicateRobotNames.displayName(each, agents), each));
        } catch (RemoteException | RuntimeException | LinkageError e) { // of a foreign proxy
          isComplete = false;
          options.answer().note(UnansweredCall.inWords(each.path(), e));
        }
      }
    }
    AgentView.show(options.answer(), views);
    return new AgentViews(views, isComplete);
  }

  /**
   * The agents' states.
   *
   * @param views of those that answered
   * @param isComplete whether all answered
   */
  record AgentViews(List<AgentView> views, boolean isComplete) {

    /** The exit code, unless another error occurred. */
    int code() {
      return isComplete ? ExitCode.SUCCESS : ExitCode.NO_ANSWER;
    }
  }

  private static List<ModuleListing<RecruitmentControl>> in(TeamDirectory team, List<String> wanted)
      throws InterruptedException {
    return RobotModules.of(
        team,
        ModuleQuery.of(RecruitmentControl.class),
        wanted,
        "recruitment agent",
        CommandName.current() + " persona list shows the robots");
  }
}
