package org.dfra.behaviors.perceptual.mines;

/**
 * Settings of the image search.
 *
 * @param radius of a mine, metres
 * @param height of a mine, metres
 * @param colour of a mine, 0xRRGGBB, of which only the proportions count
 * @param minDistance minimum distance, metres forward of the base
 * @param maxDistance maximum distance, likewise
 * @param minThermalContrast minimum temperature difference of a mine from its surroundings, kelvin
 * @param minVisibleContrast minimum natural logarithm of the brightness ratio of the surroundings
 *     to a mine
 * @param colourTolerance of the colour: maximum distance of the shares of red, green and blue
 */
public record ImageMineDetectorSettings(
    double radius,
    double height,
    int colour,
    double minDistance,
    double maxDistance,
    double minThermalContrast,
    double minVisibleContrast,
    double colourTolerance) {

  /** For anti-vehicle mines; {@code ./dfra bench mines} uses them. */
  public static final ImageMineDetectorSettings DEFAULT =
      new ImageMineDetectorSettings(0.16, 0.1, 0x3F4526, 0.9, 3.5, 1, 0.18, 0.03);

  MineModel target() {
    return new MineModel(radius, height, colour);
  }

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
}
