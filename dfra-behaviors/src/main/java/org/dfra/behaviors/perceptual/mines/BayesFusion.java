package org.dfra.behaviors.perceptual.mines;

/**
 * Bayes' rule: likelihoods multiply. An opinion is a pair of likelihoods scaled to sum 1; it has no
 * unknown share, so no evidence and balanced evidence are the same.
 */
public final class BayesFusion implements Fusion {

  private static final Opinion NOTHING = new Opinion(0.5, 0.5, 0);

  private final double prior;

  /**
   * @param prior probability of a mine without observations, above 0 and below 1
   */
  public BayesFusion(double prior) {
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
