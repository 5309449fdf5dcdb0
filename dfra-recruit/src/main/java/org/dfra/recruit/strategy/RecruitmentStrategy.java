package org.dfra.recruit.strategy;

import java.time.Duration;
import java.util.List;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.requester.BidSelector;

/**
 * Determines which robots answer a call and which one is chosen. Confined to its agent, which has
 * its own instance.
 *
 * <p>A custom strategy defines its name, which robots answer and which one is chosen; the defaults
 * are those of a strategy without an affect. {@link StrategyRegistry} describes its name in the
 * configuration.
 */
public interface RecruitmentStrategy extends BidSelector {

  /** Its name in reports and logs. */
  String name();

  /** Whether the robot offers help; called once per call, while it is capable and free. */
  boolean shouldOffer(Stimulus stimulus);

  /** Whether a robot that does not offer sends a refusal. */
  default boolean sendsRefusal() {
    return false;
  }

  /** The level of its affect, 0 to 1; 0 without an affect. */
  default double urge() {
    return 0;
  }

  /** The robot was chosen. */
  default void onChosen() {
    // no affect
  }

  /** Another robot was chosen, or no help is needed any more. */
  default void onNotChosen() {
    // no affect
  }

  /** Restores the level of its affect after a restart of its process. */
  default void restore(double urge) {
    // no affect
  }

  /** 2 s. */
  @Override
  default Duration offerWindow() {
    return Duration.ofSeconds(2);
  }

  /** One broadcast for all. */
  @Override
  default boolean notifiesIndividually() {
    return false;
  }

  /** The robot with the shortest ETA; one with an empty battery counts as twice as far. */
  static Bid nearest(List<Bid> bids) {
    Bid best = bids.get(0);
    for (Bid bid : bids) {
      if (cost(bid) < cost(best)) {
        best = bid;
      }
    }
    return best;
  }

  /** Seconds to the place, weighted by the battery. */
  private static double cost(Bid bid) {
    return bid.eta().toNanos() / 1e9 * (2 - Math.min(1, 2 * bid.battery()));
  }
}
