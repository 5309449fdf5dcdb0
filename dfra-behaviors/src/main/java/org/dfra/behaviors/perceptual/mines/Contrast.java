package org.dfra.behaviors.perceptual.mines;

/** Similarity of a window's content to a mine. Implementations are immutable. */
interface Contrast {

  /**
   * The similarity.
   *
   * @param picture of its band
   * @return 1 or more counts as a mine; below 0 it is dissimilar
   */
  double score(DecodedImage picture, DetectionWindow window);
}
