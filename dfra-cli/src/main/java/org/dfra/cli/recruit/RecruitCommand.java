package org.dfra.cli.recruit;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.agent.RecruitmentControl;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra recruit}: recruitment of helpers among robots. */
@Command(
    name = "recruit",
    description = "Shows which robots help, lets held robots help again, and compares strategies.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      RecruitCommand.RecruitStatusCommand.class,
      RecruitCommand.RecruitResumeCommand.class
    })
public final class RecruitCommand {

  /** {@code ./dfra recruit status}. */
  @Command(
      name = "status",
      description = "Shows which robots help, and which are held and answer no calls for help.",
      footer = {
        "",
        "A robot is held if an operator stopped it: by a pause, a cancel, a set brake or an",
        "emergency stop. It stays held until its search is resumed, it receives another goal,",
        "or " + CommandName.IN_HELP + " recruit resume releases it."
      })
  static final class RecruitStatusCommand implements Callable<Integer> {

    @Parameters(
        paramLabel = "ROBOT",
        arity = "0..*",
        description = "Only these robots (default: all that have a recruitment agent).")
    private List<String> robots = List.of();

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private RecruitmentAgentOptions agents;

    @Override
    public Integer call() throws Exception {
      return agents.ask(robots, agent -> {}).code();
    }
  }

  /** {@code ./dfra recruit resume}. */
  @Command(
      name = "resume",
      description =
          "Lets held robots answer calls for help again: check first that they may move. Robots that"
              + " are not held are unaffected.",
      footer = {
        "",
        "This moves no robot before the next call for help, and a paused search stays paused.",
        "It does not end an emergency stop: release that first, with "
            + CommandName.IN_HELP
            + " stop --release.",
        "Exits with 1 if a robot is still held."
      })
  static final class RecruitResumeCommand implements Callable<Integer> {

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
}
