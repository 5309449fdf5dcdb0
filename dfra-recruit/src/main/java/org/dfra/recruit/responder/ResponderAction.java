package org.dfra.recruit.responder;

import java.time.Instant;
import java.util.UUID;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.RecruitmentMessage;

/** An action of a responder. */
public sealed interface ResponderAction {

  /** Sends a message to one robot. */
  record SendToRobot(String robot, RecruitmentMessage message) implements ResponderAction {}

  /**
   * Interrupts its work, and travels to the place of the call.
   *
   * @param until end of its task lease: it does not move for the call from then on
   */
  record TravelTo(HelpCall call, Instant until) implements ResponderAction {}

  /**
   * Continues to the place of the call, with an extended lease.
   *
   * @param until the new end of its task lease
   */
  record ExtendLease(Instant until) implements ResponderAction {}

  /** Observes at the place. */
  record Observe(HelpCall call) implements ResponderAction {}

  /** Resumes the interrupted work. */
  record ResumeOwnWork(String why) implements ResponderAction {}

  /** Ends the lease on itself, if that has not ended yet. */
  record EndLease(UUID lease) implements ResponderAction {}

  /** It was chosen: resets the affect (atonement). */
  record ResetOnHelping() implements ResponderAction {}

  /** Another was chosen, or no help is needed: resets the affect (relief). */
  record ResetOnRelease() implements ResponderAction {}
}
