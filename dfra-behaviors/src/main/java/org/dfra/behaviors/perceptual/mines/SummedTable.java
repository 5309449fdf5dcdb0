package org.dfra.behaviors.perceptual.mines;

/**
 * The summed-area table of one channel: the mean of any rectangle takes four look-ups. Source: F.
 * C. Crow, "Summed-area tables for texture mapping", SIGGRAPH (1984). Immutable.
 */
final class SummedTable {

  private final int width;
  private final int height;
  private final long[] sums; // of all above and left of a pixel's upper left corner

  /**
   * @param samples row by row from the upper left, width × height of them
   */
  SummedTable(int width, int height, int[] samples) {
    this.width = width;
    this.height = height;
    this.sums = new long[(width + 1) * (height + 1)];
    for (int row = 0; row < height; row++) {
      long sum = 0;
      for (int column = 0; column < width; column++) {
        sum += samples[row * width + column];
        sums[(row + 1) * (width + 1) + column + 1] = sums[row * (width + 1) + column + 1] + sum;
      }
    }
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** Mean of the samples in a rectangle inside the image. */
  double mean(PixelRect box) {
    int above = box.top() * (width + 1);
    int below = box.bottom() * (width + 1);
    long sum =
        sums[below + box.right()]
            - sums[above + box.right()]
            - sums[below + box.left()]
            + sums[above + box.left()];
    return (double) sum / box.pixels();
  }
}
