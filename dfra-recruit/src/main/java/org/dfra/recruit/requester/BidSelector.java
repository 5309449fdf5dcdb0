package org.dfra.recruit.requester;

import java.time.Duration;
import java.util.List;

/** How a requester chooses among offers; a part of a strategy. */
public interface BidSelector {

  /**
   * For how long it waits for others after the first offer, not negative. {@link
   * org.dfra.recruit.RecruitmentSettings#offerWindow} may say another.
   */
  Duration offerWindow();

  /** One of them. Given one at least, in the order in which they came. */
  Bid choose(List<Bid> bids);

  /** Whether each robot that offered is answered by itself, rather than all at once. */
  boolean notifiesIndividually();
}
