package org.dfra.behaviors.perceptual.mines;

/**
 * A mine is darker than what lies around it, on all sides, and of a colour that is known. The light
 * that falls on it does not count: darker is a matter of ratios, and of the colour only the shares
 * of red, green and blue count.
 *
 * @param target whose colour it has
 * @param minContrast natural logarithm of how many times brighter the side that is most like it is,
 *     from which it counts as a mine
 * @param tolerance of the colour: the most that the shares may differ by, their distance
 */
record LightContrast(MineModel target, double minContrast, double tolerance) implements Contrast {

  private static final double DARKEST = 1; // level: below that there is no colour

  @Override
  public double score(DecodedImage picture, DetectionWindow window) {
    double[] inside = levels(picture, window.inside());
    BlobScore darker = new BlobScore();
    for (PixelRect box : window.surroundings()) {
      double[] beside = levels(picture, box);
      double sum = 0;
      for (int i = 0; i < inside.length; i++) {
        sum += Math.log(beside[i] / inside[i]);
      }
      darker.add(sum / inside.length);
    }
    double likeness = tolerance / Math.max(1e-6, distance(inside));
    return Math.min(darker.score(minContrast), likeness);
  }

  /** From the colour looked for, by the shares. */
  private double distance(double[] levels) {
    double sum = levels[0] + levels[1] + levels[2];
    double[] shares = target.shares();
    double squares = 0;
    for (int i = 0; i < shares.length; i++) {
      squares += Math.pow(levels[i] / sum - shares[i], 2);
    }
    return Math.sqrt(squares);
  }

  private static double[] levels(DecodedImage picture, PixelRect box) {
    double[] levels = new double[3];
    for (int i = 0; i < levels.length; i++) {
      levels[i] = Math.max(DARKEST, picture.channels().get(i).mean(box));
    }
    return levels;
  }
}
