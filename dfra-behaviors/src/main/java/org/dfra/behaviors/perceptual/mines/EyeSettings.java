package org.dfra.behaviors.perceptual.mines;

/**
 * How images are searched.
 *
 * @param radius of a mine, metres
 * @param height of a mine, metres
 * @param colour of a mine, 0xRRGGBB, of which only the proportions count
 * @param near where the search begins, metres forward of the base
 * @param far where it ends, likewise
 * @param leastHeat what a mine is warmer or colder by than all that is around it, kelvin
 * @param leastDark natural logarithm of how many times brighter than a mine all that is around it
 *     is
 * @param tolerance of the colour: how far the shares of red, green and blue may be off, their
 *     distance
 */
public record EyeSettings(
    double radius,
    double height,
    int colour,
    double near,
    double far,
    double leastHeat,
    double leastDark,
    double tolerance) {

  /** For mines against vehicles; what {@code ./dfra bench mines} measures by. */
  public static final EyeSettings DEFAULT =
      new EyeSettings(0.16, 0.1, 0x3F4526, 0.9, 3.5, 1, 0.18, 0.03);

  Target target() {
    return new Target(radius, height, colour);
  }
}
