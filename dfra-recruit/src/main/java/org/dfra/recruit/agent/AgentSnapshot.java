package org.dfra.recruit.agent;

import java.io.Serializable;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.responder.ResponderState;

/**
 * The state of an agent that survives a restart of its process.
 *
 * @param urge level of its affect, 0 to 1
 */
public record AgentSnapshot(RequesterState requester, ResponderState responder, double urge)
    implements Serializable {

  /**
   * The same after another boot: the elapsed time is unknown, so every timeout has expired. It
   * keeps what must not be repeated: the numbers of its conversations, and which conversations of
   * others it has left.
   */
  public AgentSnapshot afterAnotherBoot() {
    return new AgentSnapshot(
        RequesterState.idle(requester.conversation()), responder.afterAnotherBoot(), 0);
  }
}
