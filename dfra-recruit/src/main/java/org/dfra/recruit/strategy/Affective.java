package org.dfra.recruit.strategy;

import java.time.Duration;
import java.util.List;
import org.dfra.recruit.affect.Affect;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;

/**
 * A robot offers to help when its affect moves it; the nearest that offers within the window is
 * chosen, 1 s unless the time-outs say another.
 */
public final class Affective implements RecruitmentStrategy {

  static final String NAME = "affective";

  private final Affect affect;

  public Affective(Affect affect) {
    this.affect = affect;
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public boolean answers(Stimulus stimulus) {
    affect.heard(stimulus);
    return affect.isMoved();
  }

  @Override
  public boolean refusesAloud() {
    return false;
  }

  @Override
  public double urge() {
    return affect.level();
  }

  @Override
  public void chosen() {
    affect.atone();
  }

  @Override
  public void spared() {
    affect.relieve();
  }

  @Override
  public void restore(double urge) {
    affect.restore(urge);
  }

  @Override
  public Duration window() {
    return Duration.ofSeconds(1);
  }

  @Override
  public Bid choose(List<Bid> bids) {
    return RecruitmentStrategy.nearest(bids);
  }

  @Override
  public boolean answersOneByOne() {
    return false;
  }
}
