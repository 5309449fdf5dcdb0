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
record Facet(double[] corners, double nx, double ny, double nz, Paint paint) {

  /** The normal is found from the first three corners, which do not lie on one line. */
  static Facet of(double[] corners, Paint paint) {
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
    return new Facet(corners, x / length, y / length, z / length, paint);
  }
}
