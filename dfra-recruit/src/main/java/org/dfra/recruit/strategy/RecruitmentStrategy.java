package org.dfra.recruit.strategy;

import java.time.Duration;
import java.util.List;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.requester.BidSelector;

/**
 * Who answers a call and who is chosen. Confined to its agent, which has one of its own.
 *
 * <p>One of your own says its name, who answers and who is chosen; what it does not say is as in a
 * strategy that nothing moves. {@link StrategyRegistry} tells how it is named in configuration.
 */
public interface RecruitmentStrategy extends BidSelector {

  /** As reports and logs call it. */
  String name();

  /** Whether the robot offers to help; asked once for each call, while it is capable and free. */
  boolean shouldOffer(Stimulus stimulus);

  /** Whether a robot that does not offer says so. */
  default boolean sendsRefusal() {
    return false;
  }

  /** How much it is moved to help, 0 to 1; 0 where nothing moves it. */
  default double urge() {
    return 0;
  }

  /** It was chosen. */
  default void onChosen() {
    // nothing moves it
  }

  /** Another was chosen, or nobody is needed any more. */
  default void onNotChosen() {
    // nothing moves it
  }

  /** What it was moved by when its process died. */
  default void restore(double urge) {
    // nothing moves it
  }

  /** 2 s. */
  @Override
  default Duration offerWindow() {
    return Duration.ofSeconds(2);
  }

  /** All at once. */
  @Override
  default boolean notifiesIndividually() {
    return false;
  }

  /** The one that is there first; one with an empty battery counts as twice as far. */
  static Bid nearest(List<Bid> bids) {
    Bid best = bids.get(0);
    for (Bid bid : bids) {
      if (cost(bid) < cost(best)) {
        best = bid;
      }
    }
    return best;
  }

  /** Seconds to the place, weighed by the battery. */
  private static double cost(Bid bid) {
    return bid.eta().toNanos() / 1e9 * (2 - Math.min(1, 2 * bid.battery()));
  }
}
