package org.dfra.recruit.loss;

import java.util.HashSet;
import java.util.Set;
import java.util.random.RandomGenerator;

/** Decides which messages are lost. */
@FunctionalInterface
public interface LossModel {

  /** Whether the next message from one robot to another is lost. */
  boolean loses(String from, String to);

  /** No loss. */
  static LossModel none() {
    return (from, to) -> false;
  }

  /** Each message is lost with the same probability, independently of others. */
  final class IndependentLoss implements LossModel {

    private final double probability;
    private final RandomGenerator random;

    /**
     * @param probability 0 to 1
     */
    public IndependentLoss(double probability, RandomGenerator random) {
      if (!(probability >= 0 && probability <= 1)) {
        throw new IllegalArgumentException("loss " + probability + " is outside 0 to 1");
      }
      this.probability = probability;
      this.random = random;
    }

    @Override
    public boolean loses(String from, String to) {
      return random.nextDouble()
          < probability; // draws also where it is 0: paired runs stay aligned
    }
  }

  /**
   * Losses in bursts: each link between two robots is good or bad, and changes with each message.
   * Source: E. N. Gilbert, "Capacity of a burst-noise channel", Bell System Technical Journal 39
   * (1960), and E. O. Elliott, ibid. 42 (1963).
   */
  final class GilbertElliottLoss implements LossModel {

    private record Link(String from, String to) {}

    private final double toBad;
    private final double toGood;
    private final double lossInGood;
    private final double lossInBad;
    private final RandomGenerator random;
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
            "a bad link would never become good again; give a probability above 0 of becoming good");
      }
      this.toBad = toBad;
      this.toGood = toGood;
      this.lossInGood = lossInGood;
      this.lossInBad = lossInBad;
      this.random = random;
    }

    /**
     * A model that loses a fraction of all messages in bursts, and none between them.
     *
     * @param share fraction of all messages, 0 to below 1
     * @param burst mean length of a burst, messages, at least 1
     */
    public static GilbertElliottLoss bursts(double share, double burst, RandomGenerator random) {
      if (!(share >= 0 && share < 1 && burst >= 1)) {
        throw new IllegalArgumentException(
            "a loss of "
                + share
                + " in bursts of "
                + burst
                + " messages is impossible; give a share of 0 to less than 1, and bursts of 1 or"
                + " more");
      }
      double toGood = 1 / burst;
      return new GilbertElliottLoss(
          Math.min(1, toGood * share / (1 - share)), toGood, 0, 1, random);
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
      boolean lost = random.nextDouble() < (isBad ? lossInBad : lossInGood);
      if (random.nextDouble() < (isBad ? toGood : toBad)) {
        if (isBad) {
          bad.remove(link);
        } else {
          bad.add(link);
        }
      }
      return lost;
    }
  }
}
