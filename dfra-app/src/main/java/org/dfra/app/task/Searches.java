package org.dfra.app.task;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.dfra.app.team.Namesakes;
import org.dfra.app.team.Team;
import org.dfra.app.team.TeamOptions;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.CommandFailure;
import org.dfra.app.terminal.ExitCode;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The robots that a task is for, and where they are looked for. A picocli mix-in. */
final class Searches {

  @Option(
      names = "--robot",
      paramLabel = "NAME[,...]",
      hideParamSyntax = true,
      split = ",",
      description = "Only these robots, in this order (default: all that can, by name).")
  private String @Nullable [] robots;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private TeamOptions options;

  /** How the command answers. */
  Answer answer() {
    return options.answer();
  }

  /** Begins to look for them. */
  Team open() throws java.io.IOException {
    return options.open();
  }

  /**
   * What searches on each of the robots.
   *
   * @throws CommandFailure if there is none, or one that was named is not there
   */
  List<ModuleListing<RasterSearch>> in(Team team) throws InterruptedException {
    List<String> wanted = wanted();
    ModuleDirectory directory = team.surveyed();
    ModuleQuery<RasterSearch> any = ModuleQuery.of(RasterSearch.class);
    if (robots == null) {
      List<ModuleListing<RasterSearch>> all = new ArrayList<>(directory.find(any));
      if (all.isEmpty()) {
        throw new CommandFailure(
            ExitCode.NOT_FOUND,
            "no robot that answers has a RasterSearch; bring one up, e.g. ./dfra up"
                + " config/teams/raster/atrv1.xml, or wait longer for answers: --wait 10");
      }
      all.sort(Comparator.comparing(ModuleListing::path));
      return all;
    }
    List<ModuleListing<RasterSearch>> named = new ArrayList<>();
    for (String robot : wanted) {
      named.add(
          Namesakes.choose(robot, name -> directory.find(any.robot(name))).stream()
              .findFirst()
              .orElseThrow(
                  () ->
                      new CommandFailure(
                          ExitCode.NOT_FOUND,
                          "robot "
                              + robot
                              + " has no RasterSearch, or is not there; ./dfra persona list shows"
                              + " the robots")));
    }
    return named;
  }

  /** The names given, each once; none where nothing was said. */
  private List<String> wanted() {
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
          ExitCode.WRONG_USE, "--robot names no robot; name one, or leave it out for all");
    }
    return names;
  }
}
