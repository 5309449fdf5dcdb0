package org.dfra.behaviors.perceptual.mines;

/**
 * How images are searched.
 *
 * @param radius of a mine, metres
 * @param height of a mine, metres
 * @param colour of a mine, 0xRRGGBB, of which only the proportions count
 * @param minDistance where the search begins, metres forward of the base
 * @param maxDistance where it ends, likewise
 * @param minThermalContrast what a mine is warmer or colder by than all that is around it, kelvin
 * @param minVisibleContrast natural logarithm of how many times brighter than a mine all that is
 *     around it is
 * @param colourTolerance of the colour: how far the shares of red, green and blue may be off, their
 *     distance
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

  /** For mines against vehicles; what {@code ./dfra bench mines} measures by. */
  public static final ImageMineDetectorSettings DEFAULT =
      new ImageMineDetectorSettings(0.16, 0.1, 0x3F4526, 0.9, 3.5, 1, 0.18, 0.03);

  MineModel target() {
    return new MineModel(radius, height, colour);
  }
}
