package org.dfra.behaviors.perceptual.mines;

/**
 * Belief masses of a position; the three sum to 1.
 *
 * @param mine that there is a mine
 * @param clear that there is none
 * @param unknown assigned to neither
 */
public record Opinion(double mine, double clear, double unknown) {

  private static final double TOLERANCE = 1e-9;

  public Opinion {
    double sum = mine + clear + unknown;
    if (!(mine >= 0 && clear >= 0 && unknown >= 0 && Math.abs(sum - 1) <= TOLERANCE)) {
      throw new IllegalArgumentException(
          "shares of " + mine + ", " + clear + " and " + unknown + " are not ≥ 0 with sum 1");
    }
  }

  /** Masses in proportion to these, which are not all 0. */
  static Opinion of(double mine, double clear, double unknown) {
    double sum = mine + clear + unknown;
    return new Opinion(mine / sum, clear / sum, unknown / sum);
  }
}
