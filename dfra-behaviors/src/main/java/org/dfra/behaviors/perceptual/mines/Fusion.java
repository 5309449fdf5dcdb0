package org.dfra.behaviors.perceptual.mines;

/**
 * A calculus of evidence of one place: begin with {@link #uninformed()}, {@link #combine} it with
 * the opinion {@link #opinionOf} each look in any order, and ask for the {@link #probability}.
 *
 * <p>Combining is commutative and associative, and nothing combined with an opinion is that
 * opinion. Opinions of two calculi do not mix. Implementations are immutable.
 */
public interface Fusion {

  /** The opinion where no one has looked. */
  Opinion uninformed();

  /** The opinion that one look alone gives. */
  Opinion opinionOf(Evidence evidence);

  /** The opinion of two that rest on different looks. */
  Combined combine(Opinion one, Opinion other);

  /** How likely there is a mine, 0 to 1, with what is known of all places before a look. */
  double probability(Opinion opinion);

  /**
   * An opinion of two, and how far these were at odds.
   *
   * @param opinion of both; {@link #uninformed()} where they contradict each other wholly, which
   *     opinions of looks never do
   * @param conflict part of the shares that met their opposite, 0 to 1
   */
  record Combined(Opinion opinion, double conflict) {}
}
