package org.dfra.behaviors.perceptual.mines;

/**
 * Difference of a window's inside from each of the boxes around it. A blob differs equally from all
 * sides. A strip continues on at least one side, and an edge has one similar side: there the
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
