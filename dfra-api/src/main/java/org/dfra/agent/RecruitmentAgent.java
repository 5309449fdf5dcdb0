package org.dfra.agent;

import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/**
 * Asks other robots for help on behalf of its own robot, and decides whether its own robot helps
 * another. It finds the others by their persona: {@link org.dfra.persona.RecruitmentAttributes}
 * lists what a robot can observe.
 */
public interface RecruitmentAgent extends RecruitmentControl {

  /**
   * Receives a message from another agent. Returns at once; the message is processed later. Between
   * two virtual machines it is a remote event.
   *
   * @throws IllegalArgumentException if this agent does not know the type of message
   */
  @Idempotent
  void receive(AgentMessage message) throws RemoteException;
}
