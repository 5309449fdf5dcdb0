package org.dfra.behaviors.perceptual.mines;

/**
 * The target: a flat cylinder on the ground.
 *
 * @param radius metres
 * @param height metres
 * @param colour 0xRRGGBB, of which only the proportions count: light may be bright or dim
 */
record MineModel(double radius, double height, int colour) {

  /** Shares of red, green and blue; they sum up to 1. */
  double[] shares() {
    double red = colour >> 16 & 0xFF;
    double green = colour >> 8 & 0xFF;
    double blue = colour & 0xFF;
    double sum = red + green + blue;
    return new double[] {red / sum, green / sum, blue / sum};
  }
}
