package org.dfra.behaviors.perceptual.mines;

import org.dfra.behaviors.perceptual.mines.DetectionWindow.PixelRect;
import org.dfra.behaviors.perceptual.mines.ImageMineDetectorSettings.MineModel;

/** Similarity of a window's content to a mine. Implementations are immutable. */
interface Contrast {

  /**
   * The similarity.
   *
   * @param image of its band
   * @return 1 or more counts as a mine; below 0 it is dissimilar
   */
  double score(DecodedImage image, DetectionWindow window);

  /**
   * Difference of a window's inside from each of the boxes around it. A blob differs equally from
   * all sides. A strip continues on at least one side, and an edge has one similar side: there the
   * minimum is far below the mean. Mutable, confined to one thread.
   */
  final class BlobScore {

    /** Minimum ratio of minimum to mean of a blob. */
    private static final double ALIKE = 0.45;

    private double least = Double.POSITIVE_INFINITY;
    private double sum;
    private int count;

    void add(double difference) {
      least = Math.min(least, difference);
      sum += difference;
      count++;
    }

    /**
     * Blob score.
     *
     * @param enough minimum difference from the most similar side
     * @return 1 or more is a blob; below 0 some side differs in the opposite direction
     */
    double score(double enough) {
      if (count == 0 || least <= 0) {
        return count == 0 ? 0 : least / enough;
      }
      return least * count / sum < ALIKE ? Math.min(0.99, least / enough) : least / enough;
    }
  }

  /**
   * A mine is darker than its surroundings on all sides, and of a known colour. The result is
   * independent of the illumination: brightness is compared by ratios, and colour by the shares of
   * red, green and blue.
   *
   * @param target mine model with its colour
   * @param minContrast minimum natural logarithm of the brightness ratio of the most similar side
   *     to the mine
   * @param tolerance of the colour: maximum distance of the shares
   */
  record LightContrast(MineModel target, double minContrast, double tolerance) implements Contrast {

    private static final double DARKEST = 1; // level: below that there is no colour

    @Override
    public double score(DecodedImage image, DetectionWindow window) {
      double[] inside = levels(image, window.inside());
      BlobScore darker = new BlobScore();
      for (PixelRect box : window.surroundings()) {
        double[] beside = levels(image, box);
        double sum = 0;
        for (int i = 0; i < inside.length; i++) {
          sum += Math.log(beside[i] / inside[i]);
        }
        darker.add(sum / inside.length);
      }
      double likeness = tolerance / Math.max(1e-6, distance(inside));
      return Math.min(darker.score(minContrast), likeness);
    }

    /** Distance from the target colour, by the shares. */
    private double distance(double[] levels) {
      double sum = levels[0] + levels[1] + levels[2];
      double[] shares = target.shares();
      double squares = 0;
      for (int i = 0; i < shares.length; i++) {
        squares += Math.pow(levels[i] / sum - shares[i], 2);
      }
      return Math.sqrt(squares);
    }

    private static double[] levels(DecodedImage image, PixelRect box) {
      double[] levels = new double[3];
      for (int i = 0; i < levels.length; i++) {
        levels[i] = Math.max(DARKEST, image.channels().get(i).mean(box));
      }
      return levels;
    }
  }
}
