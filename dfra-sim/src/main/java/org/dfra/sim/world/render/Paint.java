package org.dfra.sim.world.render;

/**
 * What a surface looks like.
 *
 * @param colour 0xRRGGBB in full light
 * @param warmth how much warmer than the air it is in the shade, kelvin
 * @param sunlit part of the ground's warming that it takes on where it faces the sun, 0 to 1
 * @param leafy whether it is rough as a hedge is
 * @param label whose it is in a picture of labels; 0 for nobody's
 */
public record Paint(int colour, double warmth, double sunlit, boolean leafy, int label) {

  /** Smooth and without a label. */
  public Paint(int colour, double warmth, double sunlit) {
    this(colour, warmth, sunlit, false, 0);
  }

  /** As warm as this, however the sun shines, and labelled. */
  static Paint heated(int colour, double warmth, int label) {
    return new Paint(colour, warmth, 0, false, label);
  }
}
