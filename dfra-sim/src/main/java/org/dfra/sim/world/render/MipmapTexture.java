package org.dfra.sim.world.render;

import org.dfra.sim.world.noise.RandomStream;

/**
 * A square pattern that repeats over the ground, −128 to 127, in successively coarser levels: a
 * pixel that covers a large area gets its mean, which prevents aliasing at a distance.
 */
final class MipmapTexture {

  private static final double FAR = 1 << 20; // texels: makes every coordinate in a world positive

  private final int bits;
  private final double perMetre;
  private final double texelArea;
  private final byte[][] levels;

  /**
   * @param bits the pattern is 2 to the power of bits texels wide
   * @param texel width of a texel, metres
   * @param values row by row from the south-west, about −128 to 127
   */
  MipmapTexture(int bits, double texel, double[] values) {
    this.bits = bits;
    this.perMetre = 1 / texel;
    this.texelArea = texel * texel;
    this.levels = new byte[bits + 1][];
    double[] level = values;
    for (int l = 0; l <= bits; l++) {
      byte[] rounded = new byte[level.length];
      for (int i = 0; i < level.length; i++) {
        rounded[i] = (byte) Math.max(-128, Math.min(127, Math.round(level[i])));
      }
      levels[l] = rounded;
      level = halved(level, 1 << (bits - l));
    }
  }

  private static double[] halved(double[] values, int size) {
    int half = size / 2;
    double[] means = new double[half * half];
    for (int y = 0; y < half; y++) {
      for (int x = 0; x < half; x++) {
        int at = 2 * y * size + 2 * x;
        means[y * half + x] =
            (values[at] + values[at + 1] + values[at + size] + values[at + size + 1]) / 4;
      }
    }
    return means;
  }

  /**
   * The pattern there.
   *
   * @param area of the ground to average over, square metres
   */
  int at(double east, double north, double area) {
    int level = Math.max(0, Math.min(bits, (Math.getExponent(area / texelArea) + 1) >> 1));
    int size = bits - level;
    int mask = (1 << size) - 1;
    int x = ((int) (east * perMetre + FAR) >> level) & mask;
    int y = ((int) (north * perMetre + FAR) >> level) & mask;
    return levels[level][y << size | x];
  }

  /**
   * Smooth periodic noise: a random number at each point of a lattice, interpolated in between.
   *
   * @param bits the pattern is 2 to the power of bits wide
   * @param lattice distance of the lattice's points, a power of two
   * @param strength standard deviation of the random numbers
   * @param values the noise is added to them
   */
  static void addNoise(
      RandomStream draws, int bits, int lattice, double strength, double[] values) {
    int size = 1 << bits;
    int points = size / lattice;
    double[] drawn = new double[points * points];
    for (int i = 0; i < drawn.length; i++) {
      drawn[i] = strength * draws.gaussian(i);
    }
    for (int y = 0; y < size; y++) {
      int y0 = y / lattice;
      int y1 = (y0 + 1) % points;
      double fy = smooth((y % lattice) / (double) lattice);
      for (int x = 0; x < size; x++) {
        int x0 = x / lattice;
        int x1 = (x0 + 1) % points;
        double fx = smooth((x % lattice) / (double) lattice);
        values[y * size + x] +=
            (1 - fy) * ((1 - fx) * drawn[y0 * points + x0] + fx * drawn[y0 * points + x1])
                + fy * ((1 - fx) * drawn[y1 * points + x0] + fx * drawn[y1 * points + x1]);
      }
    }
  }

  private static double smooth(double f) {
    return f * f * (3 - 2 * f);
  }
}
