package org.dfra.behaviors.perceptual.mines;

/**
 * A method of evidence fusion for one position: start with {@link #uninformed()}, {@link #combine}
 * it with the opinion {@link #opinionOf} each observation in any order, and get the {@link
 * #probability}.
 *
 * <p>Combination is commutative and associative, and {@link #uninformed()} is its neutral element.
 * Do not mix opinions of two methods. Implementations are immutable.
 */
public interface Fusion {

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
}
