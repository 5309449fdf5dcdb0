package org.dfra.behaviors.perceptual.mines;

/**
 * How what is inside a window differs from each of the boxes around it. What differs from all sides
 * alike is a blob. A strip goes on to at least one side, and an edge has one side like itself:
 * there the least is far below the mean. Mutable, confined to one thread.
 */
final class BlobScore {

  /** Least over mean from which on it is a blob. */
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
   * How much of a blob it is.
   *
   * @param enough difference from the side that is most like it, from which on it counts
   * @return from 1 on it is one; below 0 some side differs the other way
   */
  double score(double enough) {
    if (count == 0 || least <= 0) {
      return count == 0 ? 0 : least / enough;
    }
    return least * count / sum < ALIKE ? Math.min(0.99, least / enough) : least / enough;
  }
}
