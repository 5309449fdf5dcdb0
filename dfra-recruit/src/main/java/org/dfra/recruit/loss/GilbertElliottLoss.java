package org.dfra.recruit.loss;

import java.util.HashSet;
import java.util.Set;
import java.util.random.RandomGenerator;

/**
 * Losses in bursts: each link between two robots is good or bad, and changes with each message.
 * Source: E. N. Gilbert, "Capacity of a burst-noise channel", Bell System Technical Journal 39
 * (1960), and E. O. Elliott, ibid. 42 (1963).
 */
public final class GilbertElliottLoss implements LossModel {

  private record Link(String from, String to) {}

  private final double toBad;
  private final double toGood;
  private final double lossInGood;
  private final double lossInBad;
  private final RandomGenerator lot;
  private final Set<Link> bad = new HashSet<>();

  /**
   * @param toBad probability that a good link is bad after a message, 0 to 1
   * @param toGood probability that a bad one is good, above 0 to 1
   * @param lossInGood probability of a loss on a good link, 0 to 1
   * @param lossInBad likewise on a bad one
   */
  public GilbertElliottLoss(
      double toBad, double toGood, double lossInGood, double lossInBad, RandomGenerator random) {
    for (double each : new double[] {toBad, toGood, lossInGood, lossInBad}) {
      if (!(each >= 0 && each <= 1)) {
        throw new IllegalArgumentException("probability " + each + " is outside 0 to 1");
      }
    }
    if (toGood == 0) {
      throw new IllegalArgumentException(
          "a link that stays bad for ever loses no share; let it be good");
    }
    this.toBad = toBad;
    this.toGood = toGood;
    this.lossInGood = lossInGood;
    this.lossInBad = lossInBad;
    this.lot = random;
  }

  /**
   * A model that loses a fraction of all messages in bursts, and none between them.
   *
   * @param share fraction of all messages, 0 to below 1
   * @param burst mean length of a burst, messages, at least 1
   */
  public static GilbertElliottLoss bursts(double share, double burst, RandomGenerator random) {
    if (!(share >= 0 && share < 1 && burst >= 1)) {
      throw new IllegalArgumentException("a share of " + share + " in bursts of " + burst);
    }
    double toGood = 1 / burst;
    return new GilbertElliottLoss(Math.min(1, toGood * share / (1 - share)), toGood, 0, 1, random);
  }

  /** The long-term fraction of messages lost. */
  public double share() {
    double inBad = toBad / (toBad + toGood);
    return inBad * lossInBad + (1 - inBad) * lossInGood;
  }

  @Override
  public boolean loses(String from, String to) {
    Link link = new Link(from, to);
    boolean isBad = bad.contains(link);
    boolean lost = lot.nextDouble() < (isBad ? lossInBad : lossInGood);
    if (lot.nextDouble() < (isBad ? toGood : toBad)) {
      if (isBad) {
        bad.remove(link);
      } else {
        bad.add(link);
      }
    }
    return lost;
  }
}
