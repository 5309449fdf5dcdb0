package org.dfra.app.persona;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.app.team.LastSeen;
import org.dfra.app.team.TeamDirectory;
import org.dfra.app.team.TeamOptions;
import org.dfra.app.terminal.ExitCode;
import org.dfra.app.terminal.Table;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra persona list}. */
@Command(name = "list", description = "Lists the robots of the team.")
final class PersonaListCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  @Override
  public Integer call() throws Exception {
    try (TeamDirectory team = options.open()) {
      List<RobotView> robots =
          team.awaitDirectory().personas().stream().map(RobotView::of).toList();
      Table table = new Table("ROBOT", "ROLE", "MODULES", "HOST", "SEEN");
      for (RobotView each : robots) {
        table.row(
            each.robot(),
            each.roleInWords(),
            Integer.toString(each.modules()),
            each.host().isEmpty() ? "-" : each.host(),
            LastSeen.of(each.stale(), each.confirmed()));
      }
      options.answer().table(robots, table, "No robot shows anything of itself.");
      team.noteDuplicateNames();
      return ExitCode.SUCCESS;
    }
  }
}
