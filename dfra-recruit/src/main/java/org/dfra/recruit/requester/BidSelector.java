package org.dfra.recruit.requester;

import java.time.Duration;
import java.util.List;

/** Selects among offers; a part of a strategy. */
public interface BidSelector {

  /**
   * Wait for further offers after the first, not negative. {@link
   * org.dfra.recruit.RecruitmentSettings#offerWindow} may override it.
   */
  Duration offerWindow();

  /** Selects one offer. It gets at least one, in the order of reception. */
  Bid choose(List<Bid> bids);

  /** Whether each robot that offered gets its own answer, instead of one broadcast. */
  boolean notifiesIndividually();
}
