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
    implements Serializable {}
