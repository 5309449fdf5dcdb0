package org.dfra.recruit.strategy;

import java.util.List;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;

/**
 * The Contract Net interaction protocol: every robot proposes or refuses, the nearest is accepted
 * and every other proposal rejected, each by a separate message. Source: FIPA SC00029. HELP is its
 * cfp, ACCEPT its propose, REFUSE its refuse, RESPONDER_ID its accept-proposal, RELEASE its
 * reject-proposal, ARRIVAL its inform.
 *
 * <p>It differs from that specification in two things, since its messages are those of every
 * strategy:
 *
 * <ul>
 *   <li>HELP carries no reply-by deadline. The window begins with the first proposal, and only the
 *       requester knows when it ends.
 *   <li>A proposal received after the choice is answered by a RESPONDER_ID that names the chosen
 *       robot, not by a RELEASE. Only one of an earlier conversation, or of a call that has ended,
 *       is answered by a RELEASE.
 * </ul>
 */
final class ContractNet implements RecruitmentStrategy {

  static final String NAME = "contract-net";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public boolean shouldOffer(Stimulus stimulus) {
    return true;
  }

  @Override
  public boolean sendsRefusal() {
    return true;
  }

  @Override
  public Bid choose(List<Bid> bids) {
    return RecruitmentStrategy.nearest(bids);
  }

  @Override
  public boolean notifiesIndividually() {
    return true;
  }
}
