package org.dfra.sim.world.render;

/**
 * A flat convex polygon, visible from one side.
 *
 * @param corners x, y, z of each, metres, counter-clockwise as seen from outside
 * @param nx x of the unit vector that points outside
 * @param ny its y
 * @param nz its z
 * @param paint its appearance
 */
record MeshFace(double[] corners, double nx, double ny, double nz, MeshFace.Paint paint) {

  /** The normal is found from the first three corners, which do not lie on one line. */
  static MeshFace of(double[] corners, Paint paint) {
    double ax = corners[3] - corners[0];
    double ay = corners[4] - corners[1];
    double az = corners[5] - corners[2];
    double bx = corners[6] - corners[3];
    double by = corners[7] - corners[4];
    double bz = corners[8] - corners[5];
    double x = ay * bz - az * by;
    double y = az * bx - ax * bz;
    double z = ax * by - ay * bx;
    double length = Math.sqrt(x * x + y * y + z * z);
    return new MeshFace(corners, x / length, y / length, z / length, paint);
  }

  /**
   * Appearance of a surface.
   *
   * @param colour 0xRRGGBB in full light
   * @param warmth temperature in the shade minus that of the air, kelvin
   * @param sunlit fraction of the ground's warming where it faces the sun, 0 to 1
   * @param leafy whether it has the rough texture of a hedge
   * @param label of its object in a label image; 0 for none
   */
  record Paint(int colour, double warmth, double sunlit, boolean leafy, int label) {

    /** Smooth and without a label. */
    public Paint(int colour, double warmth, double sunlit) {
      this(colour, warmth, sunlit, false, 0);
    }

    /** With a fixed warmth, independent of the sun, and a label. */
    static Paint heated(int colour, double warmth, int label) {
      return new Paint(colour, warmth, 0, false, label);
    }
  }
}
