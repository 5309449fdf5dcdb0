package org.dfra.cli.task;

import java.rmi.RemoteException;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleListing;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.Table;

/**
 * A robot's progress.
 *
 * @param robot its name; {@code robot@host} if others in the list have it
 * @param module the behavior that pursues the task, {@code robot/module}
 * @param phase its phase
 * @param progress completed share, 0 to 1
 * @param waypointsDone waypoints that were reached or given up
 * @param waypoints waypoints of the task; 0 if they are not counted
 * @param activity its activity or the reason of its inactivity, as a clause
 * @param since time of that status, by the robot's clock
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
   * Queries the robot.
   *
   * @param robot its displayed name
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

  /** Prints the views. */
  static void show(CommandOutput answer, List<TaskView> tasks) {
    Table table = new Table("ROBOT", "STATE", "DONE", "ACTIVITY");
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
