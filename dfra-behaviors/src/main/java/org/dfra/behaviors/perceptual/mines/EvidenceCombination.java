package org.dfra.behaviors.perceptual.mines;

/**
 * A method of evidence fusion for one position: start with {@link #uninformed()}, {@link #combine}
 * it with the opinion {@link #opinionOf} each observation in any order, and get the {@link
 * #probability}.
 *
 * <p>Combination is commutative and associative, and {@link #uninformed()} is its neutral element.
 * Do not mix opinions of two methods. Implementations are immutable.
 */
public interface EvidenceCombination {

  /** The opinion without observations. */
  Opinion uninformed();

  /** The opinion from one observation alone. */
  Opinion opinionOf(Evidence evidence);

  /** Combines two opinions from different observations. */
  Combined combine(Opinion one, Opinion other);

  /** Probability of a mine, 0 to 1, including the prior. */
  double probability(Opinion opinion);

  /**
   * A combined opinion, and the conflict of the two.
   *
   * @param opinion of both; {@link #uninformed()} where they contradict each other totally, which
   *     opinions from observations never do
   * @param conflict mass assigned to contradiction, 0 to 1
   */
  record Combined(Opinion opinion, double conflict) {}

  /**
   * Evidence from one observation of a position. Only the ratio of the likelihoods matters.
   * Observations are assumed independent: two from the same viewpoint and lighting are not; pass
   * them as one.
   *
   * @param ifMine likelihood of the observation where there is a mine, above 0
   * @param ifClear likelihood of the observation where there is none, above 0
   * @param trust fraction of such observations for which the likelihoods hold, 0 to 1
   */
  record Evidence(double ifMine, double ifClear, double trust) {

    public Evidence {
      double sum = ifMine + ifClear;
      if (!(ifMine > 0 && ifClear > 0 && sum < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException(
            "likelihoods of " + ifMine + " and " + ifClear + " are not both finite and above 0");
      }
      if (!(trust >= 0 && trust <= 1)) {
        throw new IllegalArgumentException("trust " + trust + " is outside 0 to 1");
      }
    }
  }

  /**
   * Belief masses of a position; the three sum to 1.
   *
   * @param mine that there is a mine
   * @param clear that there is none
   * @param unknown assigned to neither
   */
  record Opinion(double mine, double clear, double unknown) {

    private static final double TOLERANCE = 1e-9;

    public Opinion {
      double sum = mine + clear + unknown;
      if (!(mine >= 0 && clear >= 0 && unknown >= 0 && Math.abs(sum - 1) <= TOLERANCE)) {
        throw new IllegalArgumentException(
            "shares " + mine + ", " + clear + " and " + unknown + " must be 0 or more, with sum 1");
      }
    }

    /** Masses in proportion to these, which are not all 0. */
    static Opinion of(double mine, double clear, double unknown) {
      double sum = mine + clear + unknown;
      return new Opinion(mine / sum, clear / sum, unknown / sum);
    }
  }

  /** Validation of a prior probability. */
  final class PriorProbability {

    private PriorProbability() {}

    static double requireValid(double prior) {
      if (!(prior > 0 && prior < 1)) {
        throw new IllegalArgumentException(
            "prior " + prior + " is not above 0 and below 1; evidence could not change it");
      }
      return prior;
    }
  }

  /**
   * Bayes' rule: likelihoods multiply. An opinion is a pair of likelihoods scaled to sum 1; it has
   * no unknown share, so no evidence and balanced evidence are the same.
   */
  final class BayesCombination implements EvidenceCombination {

    private static final Opinion NOTHING = new Opinion(0.5, 0.5, 0);

    private final double prior;

    /**
     * @param prior probability of a mine without observations, above 0 and below 1
     */
    public BayesCombination(double prior) {
      this.prior = PriorProbability.requireValid(prior);
    }

    @Override
    public Opinion uninformed() {
      return NOTHING;
    }

    /** An untrusted observation is as likely with a mine as without: the mean of both. */
    @Override
    public Opinion opinionOf(Evidence evidence) {
      double mean = (1 - evidence.trust()) * (evidence.ifMine() + evidence.ifClear()) / 2;
      return Opinion.of(
          evidence.trust() * evidence.ifMine() + mean,
          evidence.trust() * evidence.ifClear() + mean,
          0);
    }

    @Override
    public Combined combine(Opinion one, Opinion other) {
      double conflict = one.mine() * other.clear() + one.clear() * other.mine();
      double mine = one.mine() * other.mine();
      double clear = one.clear() * other.clear();
      return new Combined(mine + clear > 0 ? Opinion.of(mine, clear, 0) : NOTHING, conflict);
    }

    @Override
    public double probability(Opinion opinion) {
      double mine = prior * opinion.mine();
      double clear = (1 - prior) * opinion.clear();
      return mine / (mine + clear);
    }
  }

  /**
   * Dempster's rule over mine and no mine: the unknown is separate from balanced evidence. An
   * observation supports only the likelier of both, by one minus the ratio of the likelihoods, and
   * assigns the rest to unknown; an untrusted observation assigns more to unknown. Source: G.
   * Shafer, "A mathematical theory of evidence" (1976), chapters 3 and 11.
   *
   * <p>With full trust it agrees with Bayes' rule in this: opinions combined with the opinion
   * (prior, 1 − prior, 0) give Bayes' probability, exactly. Otherwise {@link #probability} weighs
   * the unknown by the prior, and converges to Bayes' as the evidence grows and the unknown
   * vanishes.
   */
  final class DempsterShaferCombination implements EvidenceCombination {

    private static final Opinion NOTHING = new Opinion(0, 0, 1);

    private final double prior;

    /**
     * @param prior probability of a mine without observations, above 0 and below 1
     */
    public DempsterShaferCombination(double prior) {
      this.prior = PriorProbability.requireValid(prior);
    }

    @Override
    public Opinion uninformed() {
      return NOTHING;
    }

    @Override
    public Opinion opinionOf(Evidence evidence) {
      double mine = Math.max(0, 1 - evidence.ifClear() / evidence.ifMine()) * evidence.trust();
      double clear = Math.max(0, 1 - evidence.ifMine() / evidence.ifClear()) * evidence.trust();
      return new Opinion(mine, clear, 1 - mine - clear);
    }

    @Override
    public Combined combine(Opinion one, Opinion other) {
      double conflict = one.mine() * other.clear() + one.clear() * other.mine();
      double mine =
          one.mine() * other.mine() + one.mine() * other.unknown() + one.unknown() * other.mine();
      double clear =
          one.clear() * other.clear()
              + one.clear() * other.unknown()
              + one.unknown() * other.clear();
      double unknown = one.unknown() * other.unknown();
      return new Combined(
          mine + clear + unknown > 0 ? Opinion.of(mine, clear, unknown) : NOTHING, conflict);
    }

    @Override
    public double probability(Opinion opinion) {
      return opinion.mine() + prior * opinion.unknown();
    }
  }
}
