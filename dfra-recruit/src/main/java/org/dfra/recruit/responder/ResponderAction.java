package org.dfra.recruit.responder;

import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.RecruitmentMessage;

/** What a responder does. */
public sealed interface ResponderAction {

  /** Tells one robot. */
  record ToOne(String robot, RecruitmentMessage message) implements ResponderAction {}

  /** Leaves what it does, and goes to the place of the call. */
  record Go(HelpCall call) implements ResponderAction {}

  /** Is there and observes. */
  record Observe(HelpCall call) implements ResponderAction {}

  /** Goes on with what it left. */
  record Resume(String why) implements ResponderAction {}

  /** Ends the lease on itself, where that has not ended yet. */
  record EndLease(UUID lease) implements ResponderAction {}

  /** It was chosen: nothing to be ashamed of. */
  record Atone() implements ResponderAction {}

  /** Another was chosen, or nobody is needed: nothing to be ashamed of any more. */
  record Relieve() implements ResponderAction {}
}
