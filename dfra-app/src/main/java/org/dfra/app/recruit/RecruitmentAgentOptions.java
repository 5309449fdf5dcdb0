package org.dfra.app.recruit;

import java.io.IOException;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.agent.RecruitmentControl;
import org.dfra.app.team.DuplicateRobotNames;
import org.dfra.app.team.RobotModules;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.team.TeamOptions;
import org.dfra.app.team.UnansweredCall;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import picocli.CommandLine.Mixin;

/** The recruitment agents of a team, and where they are looked for. A picocli mix-in. */
final class RecruitmentAgentOptions {

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private TeamOptions options;

  /** What is asked of each. */
  @FunctionalInterface
  interface Request {
    void apply(RecruitmentControl agent) throws RemoteException;
  }

  /**
   * Asks it of the agents of these robots, or of all, then shows what they are doing.
   *
   * @param wanted robots; all where there is none
   * @return what those say that answer
   * @throws CommandFailure if there is none, or one that was named is not there
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
        } catch (RemoteException | RuntimeException | LinkageError e) { // a foreign proxy's own
          isComplete = false;
          options.answer().note(UnansweredCall.inWords(each.path(), e));
        }
      }
    }
    AgentView.show(options.answer(), views);
    return new AgentViews(views, isComplete);
  }

  /**
   * What the agents say.
   *
   * @param views of those that answer
   * @param isComplete whether all do
   */
  record AgentViews(List<AgentView> views, boolean isComplete) {

    /** The exit code, unless something else is wrong. */
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
        "./dfra persona list shows the robots");
  }
}
