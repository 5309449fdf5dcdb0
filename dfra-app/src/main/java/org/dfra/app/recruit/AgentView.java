package org.dfra.app.recruit;

import java.rmi.RemoteException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.agent.Recruiting;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.ResponderPhase;
import org.dfra.app.terminal.Answer;
import org.dfra.app.terminal.Table;
import org.dfra.directory.ModuleListing;

/**
 * What a recruitment agent is doing.
 *
 * @param robot its robot; {@code robot@host} where others that are shown have its name
 * @param responder its state as one that helps
 * @param helped the robot that it helps, or has offered to; empty where there is none
 * @param held why its robot answers no call; empty where it is not held
 * @param doing what changed last, as a clause
 */
record AgentView(
    String robot,
    ResponderPhase responder,
    Optional<String> helped,
    Optional<String> held,
    String doing) {

  /**
   * Asks the agent.
   *
   * @param robot its robot, as it is shown
   */
  static AgentView of(String robot, ModuleListing<Recruiting> listing) throws RemoteException {
    RecruitmentStatus status = listing.module().status();
    return new AgentView(
        robot,
        status.responder(),
        Optional.ofNullable(status.helped()),
        Optional.ofNullable(status.held()),
        status.doing());
  }

  /** Answers with these. */
  static void show(Answer answer, List<AgentView> agents) {
    Table table = new Table("ROBOT", "HELPS", "STATE", "IT");
    for (AgentView each : agents) {
      table.row(
          each.robot(),
          each.helped().orElse("-"),
          each.held().isPresent() ? "HELD" : each.responder().name().toLowerCase(Locale.ROOT),
          each.held().map(why -> "answers no call: " + why).orElse(each.doing()));
    }
    answer.table(agents, table, "no robot has a recruitment agent");
  }
}
