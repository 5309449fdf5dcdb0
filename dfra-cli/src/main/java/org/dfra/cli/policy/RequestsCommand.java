package org.dfra.cli.policy;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.cli.team.UnansweredCall;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import org.dfra.river.security.robot.PolicyControl;
import org.dfra.river.security.robot.WaitingRequest;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code ./dfra policy requests}. */
@Command(
    name = "requests",
    description = "Lists the calls that wait for an operator's confirmation.",
    footer = {
      "",
      "They are of all processes of the robots, and wait for 300 s. Answer one by "
          + CommandName.IN_HELP
          + " policy confirm",
      "or refuse. Exits with 4 if a robot does not answer."
    })
final class RequestsCommand implements Callable<Integer> {

  @Parameters(
      arity = "0..*",
      paramLabel = "ROBOT",
      description = "Only of these robots (default: of all that are found).")
  private List<String> robots = List.of();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    RobotControls.requireMember();
    List<WaitingRequest> waiting = new ArrayList<>();
    int silent = 0;
    try (TeamDirectory team = options.open()) {
      for (String each : robots.isEmpty() ? RobotControls.robots(team) : robots) {
        try {
          waiting.addAll(RobotControls.ask(team, each, PolicyControl::requests));
        } catch (IOException e) {
          silent++;
          options.answer().note(UnansweredCall.inWords(each, e));
        }
      }
    }
    Table table = new Table("REQUEST", "ROBOT", "OBJECT", "METHOD", "CALLER", "RULE", "WAITS FOR");
    for (WaitingRequest each : waiting) {
      table.row(
          each.id(),
          each.robot(),
          each.object().isEmpty() ? "-" : each.object(),
          each.method(),
          each.caller(),
          each.rule(),
          each.secondsLeft() + " s");
    }
    options.answer().table(waiting, table, "No call waits for a confirmation.");
    return silent == 0 ? ExitCode.SUCCESS : ExitCode.NO_ANSWER;
  }
}
