package org.dfra.sim.world.noise;

/**
 * A stream of random numbers with random access. The n-th 64 bits are those that {@code new
 * SplittableRandom(seed)} gives as its n-th {@code nextLong()}, since its state is a counter
 * (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
 *
 * @param seed of the stream
 */
public record RandomStream(long seed) {

  private static final long GAMMA = 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio, odd
  private static final long FNV_OFFSET = 0xCBF29CE484222325L;
  private static final long FNV_PRIME = 0x100000001B3L;
  private static final double UNIT = 0x1p-53;

  /**
   * A substream by name: another name has an independent stream. Its seed is the number at the
   * name's 64-bit FNV-1a hash.
   */
  public RandomStream substream(String name) {
    long hash = FNV_OFFSET;
    for (int i = 0; i < name.length(); i++) {
      hash = (hash ^ name.charAt(i)) * FNV_PRIME;
    }
    return substream(hash);
  }

  /** A substream by number. */
  public RandomStream substream(long number) {
    return new RandomStream(bits(number));
  }

  /** The 64 bits at an index; the first is 0. */
  public long bits(long index) {
    return bits(seed, index);
  }

  /** The 64 bits at an index of the stream of that seed. */
  public static long bits(long seed, long index) {
    long z = seed + (index + 1) * GAMMA;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** Uniformly distributed over 0 to 1, both excluded. */
  public double uniform(long index) {
    return uniformOf(bits(index));
  }

  /** Normally distributed with mean 0 and standard deviation 1. */
  public double gaussian(long index) {
    return Normal.quantile(uniform(index));
  }

  /** The number between 0 and 1, both excluded, that these bits encode. */
  public static double uniformOf(long bits) {
    return ((bits >>> 11) + 0.5) * UNIT;
  }

  /** The number of a standard normal distribution that these bits encode. */
  public static double gaussianOf(long bits) {
    return Normal.quantile(uniformOf(bits));
  }
}
