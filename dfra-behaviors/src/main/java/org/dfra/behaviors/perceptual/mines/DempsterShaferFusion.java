package org.dfra.behaviors.perceptual.mines;

/**
 * Dempster's rule over mine and no mine: the unknown is separate from balanced evidence. An
 * observation supports only the likelier of both, by one minus the ratio of the likelihoods, and
 * assigns the rest to unknown; an untrusted observation assigns more to unknown. Source: G. Shafer,
 * "A mathematical theory of evidence" (1976), chapters 3 and 11.
 *
 * <p>With full trust it agrees with Bayes' rule in this: opinions combined with the opinion (prior,
 * 1 − prior, 0) give Bayes' probability, exactly. Otherwise {@link #probability} weighs the unknown
 * by the prior, and converges to Bayes' as the evidence grows and the unknown vanishes.
 */
public final class DempsterShaferFusion implements Fusion {

  private static final Opinion NOTHING = new Opinion(0, 0, 1);

  private final double prior;

  /**
   * @param prior probability of a mine without observations, above 0 and below 1
   */
  public DempsterShaferFusion(double prior) {
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
        one.clear() * other.clear() + one.clear() * other.unknown() + one.unknown() * other.clear();
    double unknown = one.unknown() * other.unknown();
    return new Combined(
        mine + clear + unknown > 0 ? Opinion.of(mine, clear, unknown) : NOTHING, conflict);
  }

  @Override
  public double probability(Opinion opinion) {
    return opinion.mine() + prior * opinion.unknown();
  }
}
