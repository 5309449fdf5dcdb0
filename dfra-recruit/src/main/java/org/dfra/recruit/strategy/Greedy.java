package org.dfra.recruit.strategy;

import java.util.List;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;

/** Every free, capable robot offers help; the nearest is chosen. */
public final class Greedy implements RecruitmentStrategy {

  static final String NAME = "greedy";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public boolean shouldOffer(Stimulus stimulus) {
    return true;
  }

  @Override
  public Bid choose(List<Bid> bids) {
    return RecruitmentStrategy.nearest(bids);
  }
}
