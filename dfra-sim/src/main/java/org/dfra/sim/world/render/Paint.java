package org.dfra.sim.world.render;

/**
 * Appearance of a surface.
 *
 * @param colour 0xRRGGBB in full light
 * @param warmth temperature in the shade minus that of the air, kelvin
 * @param sunlit fraction of the ground's warming where it faces the sun, 0 to 1
 * @param leafy whether it has the rough texture of a hedge
 * @param label of its object in a label image; 0 for none
 */
public record Paint(int colour, double warmth, double sunlit, boolean leafy, int label) {

  /** Smooth and without a label. */
  public Paint(int colour, double warmth, double sunlit) {
    this(colour, warmth, sunlit, false, 0);
  }

  /** With a fixed warmth, independent of the sun, and a label. */
  static Paint heated(int colour, double warmth, int label) {
    return new Paint(colour, warmth, 0, false, label);
  }
}
