package org.dfra.recruit.responder;

import java.time.Duration;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.recruit.message.RecruitmentMessage.Help;

/** What a responder asks its robot and its strategy. */
public interface ResponderPolicy {

  /**
   * What it could offer.
   *
   * @param eta how long it takes to be there
   * @param battery charge left, 0 to 1
   */
  record Offer(Duration eta, double battery) {}

  /** What it could offer now; nothing where it cannot observe the percept, come, or is not free. */
  Optional<Offer> offer(HelpCall call);

  /** Whether it offers. Asked once for each call of a conversation, and only while it is free. */
  boolean shouldOffer(Help help, Offer offer);

  /** Whether it says so when it does not. */
  boolean sendsRefusal();
}
