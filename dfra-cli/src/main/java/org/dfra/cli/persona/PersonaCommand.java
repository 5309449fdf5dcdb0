package org.dfra.cli.persona;

import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.team.LastSeen;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.report.terminal.ExitCode;
import org.dfra.report.terminal.Table;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code ./dfra persona}: the attributes that the team's robots publish. */
@Command(
    name = "persona",
    description = "Shows the team's robots, and finds modules by what they can do.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      PersonaCommand.PersonaListCommand.class,
      PersonaShowCommand.class,
      FindCommand.class
    })
public final class PersonaCommand {

  /** {@code ./dfra persona list}. */
  @Command(name = "list", description = "Lists the robots of the team.")
  static final class PersonaListCommand implements Callable<Integer> {

    @Mixin
    @SuppressWarnings("NullAway.Init") // set by picocli before the call
    private TeamOptions options;

    @Override
    public Integer call() throws Exception {
      try (TeamDirectory team = options.open()) {
        List<RobotView> robots =
            team.awaitDirectory().personas().stream().map(RobotView::of).toList();
        Table table = new Table("ROBOT", "ROLE", "MODULES", "HOST", "LAST SEEN");
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
}
