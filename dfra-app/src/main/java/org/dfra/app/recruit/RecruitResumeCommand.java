package org.dfra.app.recruit;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.agent.RecruitmentControl;
import org.dfra.app.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra recruit resume}. */
@Command(
    name = "resume",
    description =
        "Has held robots answer calls for help again: see first that they may move. A robot that"
            + " is not held is left alone.",
    footer = {
      "",
      "Nothing moves by this before the next call for help, and a search that is paused stays",
      "paused. It ends no emergency stop: release that first, with ./dfra stop --release. Ends",
      "with 1 where a robot is held nevertheless."
    })
final class RecruitResumeCommand implements Callable<Integer> {

  @Parameters(paramLabel = "ROBOT", arity = "1..*", description = "The robots.")
  private List<String> robots = List.of();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private RecruitmentAgentOptions agents;

  @Override
  public Integer call() throws Exception {
    RecruitmentAgentOptions.AgentViews answers = agents.ask(robots, RecruitmentControl::resume);
    boolean isHeld = answers.views().stream().anyMatch(each -> each.held().isPresent());
    return isHeld ? ExitCode.FAILED : answers.code();
  }
}
