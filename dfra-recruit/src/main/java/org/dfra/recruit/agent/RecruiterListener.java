package org.dfra.recruit.agent;

import org.dfra.agent.RecruitmentStatus;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;

/** Observes an agent. It must not block or call the agent. */
public interface RecruiterListener {

  /**
   * The agent sent a message, to one robot or, where {@code to} is empty, to all that can observe
   * the percept.
   */
  default void sent(String to, MessageEnvelope envelope) {}

  /** The agent received a message. */
  default void received(MessageEnvelope envelope) {}

  /** The agent executes an action as requester. */
  default void performed(RequesterAction action) {}

  /** The agent executes an action as responder. */
  default void performed(ResponderAction action) {}

  /** The state to store; its actions follow afterwards. */
  default void snapshotChanged(AgentSnapshot snapshot) {}

  /** The status has changed. */
  default void statusChanged(RecruitmentStatus status) {}
}
