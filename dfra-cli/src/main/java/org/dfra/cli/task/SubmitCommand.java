package org.dfra.cli.task;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.behaviors.raster.RasterPlan;
import org.dfra.behaviors.raster.Region;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleListing;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra task submit}. */
@Command(
    name = "submit",
    description = "Starts a task on robots: they move.",
    footer = {
      "",
      "raster: search a region lane by lane. The second robot drives the lanes in the",
      "opposite direction, and so on. A robot that has another task refuses; cancel that task",
      "first. If one robot refuses, none begins."
    })
final class SubmitCommand implements Callable<Integer> {

  /** The available tasks. */
  enum Task {
    RASTER
  }

  @Parameters(index = "0", paramLabel = "TASK", description = "The task: raster.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Task task;

  @Option(
      names = "--region",
      paramLabel = "REGION",
      required = true,
      description =
          "The region to search: a GeoJSON file, or corners as in " + GivenRegion.EXAMPLE + ".")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private String text;

  @Option(
      names = "--swath",
      paramLabel = "M",
      description =
          "Width of the strip that a robot sees, in metres (default " + LaneSettings.SWATH + ").")
  private @Nullable Double swath;

  @Option(
      names = "--spacing",
      paramLabel = "M",
      description =
          "Distance between lanes, in metres, at most the swath (default: "
              + LaneSettings.SPACING_FRACTION
              + " of it).")
  private @Nullable Double spacing;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TaskRobotOptions searches;

  @Override
  public Integer call() throws Exception {
    LaneSettings lanes = LaneSettings.of(swath, spacing);
    GivenRegion given = GivenRegion.parse(text);
    given.requireWider(lanes.spacing());
    try {
      RasterPlan unusedPlan = RasterPlan.of(goal(given.region(), lanes, 0));
    } catch (GoalRefusedException e) {
      throw given.withLocation(e);
    }
    try (TeamDirectory team = searches.open()) {
      List<ModuleListing<RasterSearch>> robots = searches.find(team);
      requireIdle(robots);
      begin(robots, given.region(), lanes);
      List<TaskView> begun = new ArrayList<>();
      for (ModuleListing<RasterSearch> each : robots) {
        begun.add(TaskView.of(DuplicateRobotNames.displayName(each, robots), each));
      }
      TaskView.show(searches.answer(), begun);
      searches.answer().note("how far they are: " + CommandName.current() + " task status");
    }
    return ExitCode.SUCCESS;
  }

  /** A busy robot would refuse the goal; this check fails before another robot has started. */
  private static void requireIdle(List<ModuleListing<RasterSearch>> robots) throws RemoteException {
    for (ModuleListing<RasterSearch> each : robots) {
      BehaviorStatus status = each.module().status();
      if (status.phase().isUnderWay()) {
        throw GoalRefusedException.busy(
            each.path()
                + " pursues another goal ("
                + status.activity()
                + "); cancel that first, or wait for its end: "
                + CommandName.current()
                + " task cancel");
      }
    }
  }

  /** Starts all robots, or none. */
  private void begin(List<ModuleListing<RasterSearch>> robots, Region region, LaneSettings lanes)
      throws RemoteException {
    int asked = 0;
    try {
      while (asked < robots.size()) {
        var unusedGoal = robots.get(asked).module().pursue(goal(region, lanes, asked));
        asked++;
      }
    } catch (RemoteException | RuntimeException e) {
      // A robot that did not answer may have started. A robot with another goal by now must keep
      // it.
      int last = e instanceof RemoteException ? asked : asked - 1;
      for (int i = 0; i <= last; i++) {
        cancel(robots.get(i));
      }
      throw e;
    }
  }

  private void cancel(ModuleListing<RasterSearch> robot) {
    try {
      robot.module().cancel();
      searches.answer().note(robot.path() + " had begun and was cancelled");
    } catch (RemoteException | RuntimeException e) {
      searches
          .answer()
          .note(robot.path() + " may have begun, and cannot be cancelled: " + e.getMessage());
    }
  }

  private static RasterGoal goal(Region region, LaneSettings lanes, int robot) {
    return new RasterGoal(region.corners(), lanes.swath(), lanes.spacing(), robot % 2 == 1);
  }
}
