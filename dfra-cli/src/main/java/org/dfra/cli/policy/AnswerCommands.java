package org.dfra.cli.policy;

import java.util.Map;
import java.util.concurrent.Callable;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra policy confirm} and {@code refuse}. */
final class AnswerCommands {

  private AnswerCommands() {}

  /** {@code ./dfra policy confirm}. */
  @Command(
      name = "confirm",
      description = "Confirms a call that waits: its caller may make it once, within 300 s.")
  static final class Confirm extends Answer {
    Confirm() {
      super(true, "is confirmed: its caller may call once, within 300 s");
    }
  }

  /** {@code ./dfra policy refuse}. */
  @Command(name = "refuse", description = "Refuses a call that waits, for 300 s.")
  static final class Refuse extends Answer {
    Refuse() {
      super(false, "is refused: its caller can ask again in 300 s");
    }
  }

  /** What both have in common. */
  abstract static class Answer implements Callable<Integer> {

    private final boolean isConfirmed;
    private final String outcome;

    @Parameters(index = "0", paramLabel = "ROBOT", description = "Name of the robot.")
    private String robot = "";

    @Parameters(
        index = "1",
        paramLabel = "REQUEST",
        description = "The request; " + CommandName.IN_HELP + " policy requests shows it.")
    private String request = "";

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TeamOptions options;

    Answer(boolean isConfirmed, String outcome) {
      this.isConfirmed = isConfirmed;
      this.outcome = outcome;
    }

    @Override
    public Integer call() throws Exception {
      RobotControls.requireMember();
      boolean isAnswered;
      try (TeamDirectory team = options.open()) {
        isAnswered = RobotControls.ask(team, robot, each -> each.answer(request, isConfirmed));
      }
      if (!isAnswered) {
        throw new CommandFailure(
            ExitCode.NOT_FOUND,
            "no request "
                + request
                + " waits at "
                + robot
                + "; "
                + CommandName.current()
                + " policy requests shows those that do");
      }
      options
          .answer()
          .sentence(
              Map.of("robot", robot, "request", request, "confirmed", isConfirmed),
              "Request " + request + " of " + robot + " " + outcome + ".");
      return ExitCode.SUCCESS;
    }
  }
}
