package org.dfra.recruit.responder;

import java.time.Duration;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.RecruitmentMessage.Help;

/** A responder's queries of its robot and its strategy. */
public interface ResponderPolicy {

  /**
   * A possible offer.
   *
   * @param eta time to reach the place
   * @param battery charge left, 0 to 1
   */
  record Offer(Duration eta, double battery) {}

  /**
   * Its possible offer now; empty where it cannot observe the percept, cannot come, or is not free.
   */
  Optional<Offer> offer(HelpCall call);

  /** Whether it offers. Called once per call of a conversation, and only while it is free. */
  boolean shouldOffer(Help help, Offer offer);

  /** Whether it sends a refusal when it does not offer. */
  boolean sendsRefusal();
}
