package org.dfra.recruit.strategy;

import java.time.Duration;
import java.util.List;
import org.dfra.recruit.affect.Affect;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;

/**
 * A robot offers help when its affect reaches its threshold; the nearest that offers within the
 * window is chosen. The window is 1 s unless the settings override it.
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
  public boolean shouldOffer(Stimulus stimulus) {
    affect.stimulate(stimulus);
    return affect.isTriggered();
  }

  @Override
  public boolean sendsRefusal() {
    return false;
  }

  @Override
  public double urge() {
    return affect.level();
  }

  @Override
  public void onChosen() {
    affect.onHelping();
  }

  @Override
  public void onNotChosen() {
    affect.onRelease();
  }

  @Override
  public void restore(double urge) {
    affect.restore(urge);
  }

  @Override
  public Duration offerWindow() {
    return Duration.ofSeconds(1);
  }

  @Override
  public Bid choose(List<Bid> bids) {
    return RecruitmentStrategy.nearest(bids);
  }

  @Override
  public boolean notifiesIndividually() {
    return false;
  }
}
