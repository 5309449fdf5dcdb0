package org.dfra.app.task;

import java.rmi.RemoteException;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dfra.app.terminal.CommandOutput;
import org.dfra.app.terminal.Table;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleListing;

/**
 * How far a robot is.
 *
 * @param robot its name; {@code robot@host} where others that are shown have it
 * @param module what pursues the task, {@code robot/module}
 * @param phase what it is at
 * @param progress share of it that is reached, 0 to 1
 * @param waypointsDone waypoints that are dealt with
 * @param waypoints waypoints of the task; 0 where they are not counted
 * @param activity what it does or why it does not, as a clause
 * @param since when it said so, by the robot's clock
 */
record TaskView(
    String robot,
    String module,
    BehaviorStatus.Phase phase,
    double progress,
    int waypointsDone,
    int waypoints,
    String activity,
    Instant since) {

  /**
   * Asks the robot.
   *
   * @param robot its name, as it is shown
   */
  static TaskView of(String robot, ModuleListing<RasterSearch> listing) throws RemoteException {
    BehaviorStatus status = listing.module().status();
    return new TaskView(
        robot,
        listing.path(),
        status.phase(),
        status.completion(),
        status.completedParts(),
        status.totalParts(),
        status.activity(),
        status.measured());
  }

  /** Answers with these. */
  static void show(CommandOutput answer, List<TaskView> tasks) {
    Table table = new Table("ROBOT", "TASK", "DONE", "IT");
    for (TaskView each : tasks) {
      table.row(
          each.robot(),
          each.phase().name().toLowerCase(Locale.ROOT),
          String.format(Locale.ROOT, "%.0f %%", 100 * each.progress()),
          each.activity());
    }
    answer.table(tasks, table, "no robot has a task");
  }
}
