package org.dfra.behaviors.perceptual.mines;

/** How much what is in a window looks like a mine. Implementations are immutable. */
interface Contrast {

  /**
   * The likeness.
   *
   * @param picture of the band that it is made for
   * @return from 1 on it is taken for a mine; below 0 it is anything but
   */
  double score(DecodedImage picture, DetectionWindow window);
}
