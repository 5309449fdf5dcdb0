package org.dfra.recruit.responder;

import java.time.Instant;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.RecruitmentMessage;

/** What a responder does. */
public sealed interface ResponderAction {

  /** Tells one robot. */
  record SendToRobot(String robot, RecruitmentMessage message) implements ResponderAction {}

  /**
   * Leaves what it does, and goes to the place of the call.
   *
   * @param until when its lease of the task ends: it does not move for the call from then on
   */
  record TravelTo(HelpCall call, Instant until) implements ResponderAction {}

  /**
   * Goes on to the place of the call, and has longer to get there.
   *
   * @param until when its lease of the task ends now
   */
  record ExtendLease(Instant until) implements ResponderAction {}

  /** Is there and observes. */
  record Observe(HelpCall call) implements ResponderAction {}

  /** Goes on with what it left. */
  record ResumeOwnWork(String why) implements ResponderAction {}

  /** Ends the lease on itself, where that has not ended yet. */
  record EndLease(UUID lease) implements ResponderAction {}

  /** It was chosen: nothing to be ashamed of. */
  record Atone() implements ResponderAction {}

  /** Another was chosen, or nobody is needed: nothing to be ashamed of any more. */
  record Relieve() implements ResponderAction {}
}
