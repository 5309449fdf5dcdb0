package org.dfra.recruit.requester;

import java.util.ArrayList;
import java.util.List;

/** Offers, one per robot. */
final class BidList {

  private BidList() {}

  /** Adds an offer, which replaces an earlier one of its robot; an outdated one is ignored. */
  static List<Bid> with(List<Bid> bids, Bid fresh) {
    List<Bid> all = new ArrayList<>(bids);
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).robot().equals(fresh.robot())) {
        if (fresh.number() > all.get(i).number()) {
          all.set(i, fresh);
        }
        return all;
      }
    }
    all.add(fresh);
    return all;
  }

  static List<Bid> without(List<Bid> bids, String robot) {
    return bids.stream().filter(bid -> !bid.robot().equals(robot)).toList();
  }
}
