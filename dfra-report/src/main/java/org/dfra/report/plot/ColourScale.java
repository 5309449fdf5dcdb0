package org.dfra.report.plot;

import java.awt.Color;

/**
 * Colour scales. They differ in blue and yellow and in lightness, which colour-blind readers see
 * too.
 */
enum ColourScale {
  /** From dark blue to light yellow: the higher, the lighter. */
  RISING(0x14264F, 0x2B5A8A, 0x5E8F97, 0xA9BE86, 0xFBEFA0),
  /** From blue over white to brown: lighter towards the middle. */
  AROUND_ZERO(0x0B3C6F, 0x5B93C6, 0xF5F5F5, 0xD98E4A, 0x7A3205);

  private final int[] anchors;

  ColourScale(int... anchors) {
    this.anchors = anchors;
  }

  /** The scale for a range: symmetric if the middle is zero. */
  static ColourScale of(Range range) {
    boolean isAroundZero = Math.abs(range.low() + range.high()) < 1e-6 * range.length();
    return isAroundZero ? AROUND_ZERO : RISING;
  }

  /**
   * A colour.
   *
   * @param part 0 for the low end, 1 for the high one
   */
  Color at(double part) {
    double place = Math.min(1, Math.max(0, part)) * (anchors.length - 1);
    int below = Math.min(anchors.length - 2, (int) place);
    return mixed(new Color(anchors[below]), new Color(anchors[below + 1]), place - below);
  }

  /** The same, light enough for text on it. */
  Color tint(double part) {
    return mixed(at(part), Palette.PAPER, 0.55);
  }

  private static Color mixed(Color one, Color other, double part) {
    return new Color(
        mixed(one.getRed(), other.getRed(), part),
        mixed(one.getGreen(), other.getGreen(), part),
        mixed(one.getBlue(), other.getBlue(), part));
  }

  private static int mixed(int one, int other, double part) {
    return (int) Math.round(one + part * (other - one));
  }
}
