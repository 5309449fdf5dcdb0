package org.dfra.cli.recruit;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.agent.RecruitmentControl;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.ResponderPhase;
import org.dfra.directory.ModuleListing;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.Table;

/**
 * A recruitment agent's state.
 *
 * @param robot its robot; {@code robot@host} if others in the list have its name
 * @param responder its state as a helper
 * @param helpedRobot the robot that it helps, or has offered to help; empty if there is none
 * @param held why its robot is suspended from recruitment; empty if it is not suspended
 * @param activity its last change, as a clause
 */
record AgentView(
    String robot,
    ResponderPhase responder,
    Optional<String> helpedRobot,
    Optional<String> held,
    String activity) {

  /**
   * Queries the agent.
   *
   * @param robot its robot's displayed name
   */
  static AgentView of(String robot, ModuleListing<RecruitmentControl> listing)
      throws RemoteException {
    RecruitmentStatus status = listing.module().status();
    return new AgentView(
        robot,
        status.responderPhase(),
        Optional.ofNullable(status.helpedRobot()),
        Optional.ofNullable(status.holdReason()),
        status.lastChange());
  }

  /** Prints the views. */
  static void show(CommandOutput answer, List<AgentView> agents) {
    Table table = new Table("ROBOT", "HELPS", "STATE", "ACTIVITY");
    for (AgentView each : agents) {
      table.row(
          each.robot(),
          each.helpedRobot().orElse("-"),
          each.held().isPresent() ? "HELD" : each.responder().name().toLowerCase(Locale.ROOT),
          each.held().map(why -> "answers no call: " + why).orElse(each.activity()));
    }
    answer.table(agents, table, "no robot has a recruitment agent");
  }
}
