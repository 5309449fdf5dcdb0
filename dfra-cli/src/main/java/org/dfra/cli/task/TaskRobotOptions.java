package org.dfra.cli.task;

import java.util.Arrays;
import java.util.List;
import org.dfra.behavior.RasterSearch;
import org.dfra.cli.team.RobotModules;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The robots for a task, and where they are discovered. A picocli mix-in. */
final class TaskRobotOptions {

  @Option(
      names = "--robot",
      paramLabel = "NAME[,...]",
      hideParamSyntax = true,
      split = ",",
      description = "Only these robots, in this order (default: all that can, sorted by name).")
  private String @Nullable [] robots;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions options;

  /** The command's output. */
  CommandOutput answer() {
    return options.answer();
  }

  /** Starts the discovery. */
  TeamDirectory open() throws java.io.IOException {
    return options.open();
  }

  /**
   * The search behavior of each of the robots.
   *
   * @throws CommandFailure if there is none, or a named one was not found
   */
  List<ModuleListing<RasterSearch>> find(TeamDirectory team) throws InterruptedException {
    List<String> wanted = robotNames(); // it may be rejected before any wait
    return RobotModules.of(
        team,
        ModuleQuery.of(RasterSearch.class),
        wanted,
        "RasterSearch",
        "bring one up, e.g. " + CommandName.current() + " up config/teams/raster/atrv1.xml");
  }

  /** The distinct names given; empty if none were given. */
  private List<String> robotNames() {
    if (robots == null) {
      return List.of();
    }
    List<String> names =
        Arrays.stream(robots)
            .map(String::strip)
            .filter(name -> !name.isEmpty())
            .distinct()
            .toList();
    if (names.isEmpty()) {
      throw new CommandFailure(
          ExitCode.USAGE_ERROR, "--robot names no robot; name one, or leave it out for all");
    }
    return names;
  }
}
