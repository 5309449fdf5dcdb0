package org.dfra.recruit.loss;

import java.util.random.RandomGenerator;

/** Each message is lost with the same probability, independently of others. */
public final class IndependentLoss implements LossModel {

  private final double probability;
  private final RandomGenerator lot;

  /**
   * @param probability 0 to 1
   */
  public IndependentLoss(double probability, RandomGenerator random) {
    if (!(probability >= 0 && probability <= 1)) {
      throw new IllegalArgumentException("loss " + probability + " is outside 0 to 1");
    }
    this.probability = probability;
    this.lot = random;
  }

  @Override
  public boolean loses(String from, String to) {
    return lot.nextDouble() < probability; // draws also where it is 0: paired runs stay aligned
  }
}
