package org.dfra.app.task;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import org.dfra.app.team.Namesakes;
import org.dfra.app.team.Team;
import org.dfra.app.team.Unanswered;
import org.dfra.app.terminal.ExitCode;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleListing;

/** Something that is said to each of several robots, after which it is asked how far it is. */
final class Order {

  private final Searches searches;

  Order(Searches searches) {
    this.searches = searches;
  }

  /** What is said. */
  @FunctionalInterface
  interface Said {
    void to(RasterSearch search) throws RemoteException;
  }

  /**
   * Says it to all of them, also where one does not answer.
   *
   * @return the exit code
   */
  int give(Said said) throws Exception {
    int silent = 0;
    List<TaskView> tasks = new ArrayList<>();
    try (Team team = searches.open()) {
      List<ModuleListing<RasterSearch>> all = searches.in(team);
      for (ModuleListing<RasterSearch> each : all) {
        try {
          said.to(each.module());
          tasks.add(TaskView.of(Namesakes.robot(each, all), each));
        } catch (RemoteException | RuntimeException | LinkageError e) {
          if (all.size() == 1 && !(e instanceof RemoteException)) {
            throw e; // its own refusal is the whole answer
          }
          silent++; // the others are to stop all the same
          searches.answer().remark(Unanswered.inWords(each.path(), e));
        }
      }
    }
    TaskView.show(searches.answer(), tasks);
    return silent == 0 ? ExitCode.WELL : ExitCode.NO_ANSWER;
  }
}
