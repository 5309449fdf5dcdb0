package org.dfra.recruit.agent;

import java.io.Serializable;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.responder.ResponderState;

/**
 * What of an agent outlives its process.
 *
 * @param urge how much it was moved to help, 0 to 1
 */
public record AgentSnapshot(RequesterState requester, ResponderState responder, double urge)
    implements Serializable {

  /**
   * The same after another boot: nobody knows how much time has passed, so every span of it is
   * over. What must not be repeated is known: the numbers of its conversations, and in which of
   * others' it has no part any more.
   */
  public AgentSnapshot afterAnotherBoot() {
    return new AgentSnapshot(
        RequesterState.idle(requester.conversation()), responder.afterAnotherBoot(), 0);
  }
}
