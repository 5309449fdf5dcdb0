package org.dfra.agent;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Asks other robots for help on behalf of its own, and decides whether its own helps another. It
 * finds the others by their persona: {@link org.dfra.persona.RecruitmentAttributes} says what a
 * robot can observe.
 */
public interface RecruitmentAgent extends RecruitmentControl {

  /**
   * Takes a message from another agent. Returns at once; what follows from it, follows later.
   * Between two virtual machines it is a remote event.
   *
   * @throws IllegalArgumentException if it is none that this agent knows
   */
  @Idempotent
  void receive(AgentMessage message) throws RemoteException;
}
