package org.dfra.recruit.agent;

import org.dfra.agent.RecruitmentStatus;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;

/** Watches an agent. Must not block, and must not call it. */
public interface RecruiterListener {

  /** It sent something, to one robot or, where {@code to} is empty, to all that can. */
  default void sent(String to, MessageEnvelope letter) {}

  /** Something has come. */
  default void received(MessageEnvelope letter) {}

  /** It does this as one that needs help. */
  default void performed(RequesterAction action) {}

  /** It does this as one that helps. */
  default void performed(ResponderAction action) {}

  /** This is to be kept; whatever follows from it is done afterwards. */
  default void snapshotChanged(AgentSnapshot snapshot) {}

  /** It is at something else. */
  default void statusChanged(RecruitmentStatus status) {}
}
