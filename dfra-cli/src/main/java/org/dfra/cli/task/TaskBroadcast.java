package org.dfra.cli.task;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.behavior.RasterSearch;
import org.dfra.cli.team.DuplicateRobotNames;
import org.dfra.cli.team.TeamDirectory;
import org.dfra.cli.team.UnansweredCall;
import org.dfra.directory.ModuleListing;
import org.dfra.report.terminal.ExitCode;

/** An action on each of several robots, followed by a status query. */
final class TaskBroadcast {

  private final TaskRobotOptions searches;

  TaskBroadcast(TaskRobotOptions searches) {
    this.searches = searches;
  }

  /** The action. */
  @FunctionalInterface
  interface SearchAction {
    void apply(RasterSearch search) throws RemoteException;
  }

  /**
   * Executes it on all robots, even if one does not answer.
   *
   * @return the exit code
   */
  int send(SearchAction action) throws Exception {
    int silent = 0;
    List<TaskView> tasks = new ArrayList<>();
    try (TeamDirectory team = searches.open()) {
      List<ModuleListing<RasterSearch>> all = searches.find(team);
      for (ModuleListing<RasterSearch> each : all) {
        try {
          action.apply(each.module());
          tasks.add(TaskView.of(DuplicateRobotNames.displayName(each, all), each));
        } catch (RemoteException | RuntimeException | LinkageError e) {
          if (all.size() == 1 && !(e instanceof RemoteException)) {
            throw e; // its own refusal is the complete answer
          }
          silent++; // the other robots must still stop
          searches.answer().note(UnansweredCall.inWords(each.path(), e));
        }
      }
    }
    TaskView.show(searches.answer(), tasks);
    return silent == 0 ? ExitCode.SUCCESS : ExitCode.NO_ANSWER;
  }
}
