package org.dfra.sim.world;

import org.dfra.sim.world.noise.RandomStream;

/**
 * Slope of the ground under a robot: an even field, or one whose slope varies smoothly between the
 * points of a lattice. The ground itself stays a plane; only bodies tilt.
 */
final class Terrain {

  private static final double SPACING = 1.5; // metres between two points of the lattice

  /** Between the points of a lattice the slope varies less: its variance is 4/9 on average. */
  private static final double MAKE_UP = 1.5;

  private static final long ROW = 1_000_003; // numbers of points in a row of the lattice

  private final double roughness;
  private final RandomStream eastward;
  private final RandomStream northward;

  /**
   * @param roughness σ of the slope, radians
   */
  Terrain(double roughness, RandomStream draws) {
    this.roughness = roughness;
    this.eastward = draws.substream("eastward");
    this.northward = draws.substream("northward");
  }

  /** Roll of a body there, radians, left side up is +. */
  double roll(double east, double north, double cos, double sin) {
    return roughness == 0
        ? 0
        : cos * slope(northward, east, north) - sin * slope(eastward, east, north);
  }

  /** Pitch of a body there, radians, nose down is +. */
  double pitch(double east, double north, double cos, double sin) {
    return roughness == 0
        ? 0
        : -cos * slope(eastward, east, north) - sin * slope(northward, east, north);
  }

  private double slope(RandomStream draws, double east, double north) {
    double x = Math.floor(east / SPACING);
    double y = Math.floor(north / SPACING);
    double fx = east / SPACING - x;
    double fy = north / SPACING - y;
    long at = (long) x + (long) y * ROW;
    return roughness
        * MAKE_UP
        * ((1 - fx) * ((1 - fy) * draws.gaussian(at) + fy * draws.gaussian(at + ROW))
            + fx * ((1 - fy) * draws.gaussian(at + 1) + fy * draws.gaussian(at + ROW + 1)));
  }
}
