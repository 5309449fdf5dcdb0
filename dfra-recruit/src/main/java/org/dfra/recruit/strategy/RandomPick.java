package org.dfra.recruit.strategy;

import java.util.List;
import java.util.random.RandomGenerator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.requester.Bid;

/**
 * Each free, capable robot offers help at random, by default with probability one half; the helper
 * is chosen at random.
 */
public final class RandomPick implements RecruitmentStrategy {

  static final String NAME = "random";

  /** Default probability that a robot offers. */
  public static final double DEFAULT_OFFER_PROBABILITY = 0.5;

  private final RandomGenerator random;
  private final double chance;

  /**
   * @param random seeded for reproducible runs
   * @param offerProbability probability that a robot offers, above 0 and at most 1
   */
  public RandomPick(RandomGenerator random, double offerProbability) {
    if (!(offerProbability > 0 && offerProbability <= 1)) {
      throw new ConfigurationException(
          "the offer probability " + offerProbability + " must be above 0 and at most 1");
    }
    this.random = random;
    this.chance = offerProbability;
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public boolean shouldOffer(Stimulus stimulus) {
    // one int of 2^32 ones, so a chance of one half draws as nextBoolean does: runs stay the same
    return random.nextInt() < Math.scalb(chance, Integer.SIZE) + Integer.MIN_VALUE;
  }

  @Override
  public Bid choose(List<Bid> bids) {
    return bids.get(random.nextInt(bids.size()));
  }
}
