package org.dfra.sim.world.noise;

import java.util.Arrays;

/**
 * Noise with a memory: a first-order Gauss-Markov process or a random walk in steps of equal
 * length, {@code x(n) = keep · x(n−1) + push · gaussian(n)}.
 *
 * <p>It advances step by step to the requested step, so its values depend on the stream alone. It
 * stores the last {@value #REMEMBERED} steps for late queries. Confined to the world's monitor.
 */
public final class CorrelatedNoise {

  /** Number of steps stored for late queries. */
  public static final int REMEMBERED = 256;

  private final RandomStream draws;
  private final double keep;
  private final double push;
  private final double[] values = new double[REMEMBERED];
  private long last;

  private CorrelatedNoise(RandomStream draws, double first, double keep, double push) {
    this.draws = draws;
    this.keep = keep;
    this.push = push;
    Arrays.fill(values, first);
  }

  /**
   * A first-order Gauss-Markov process: normally distributed at every time, with autocorrelation
   * {@code exp(−t/time)}.
   *
   * @param sigma its standard deviation, not negative
   * @param time its correlation time, seconds, above 0
   * @param step from one step to the next, seconds
   */
  public static CorrelatedNoise gaussMarkov(
      RandomStream draws, double sigma, double time, double step) {
    double keep = StrictMath.exp(-step / time);
    double push = sigma * Math.sqrt(1 - keep * keep);
    return new CorrelatedNoise(draws, sigma * draws.gaussian(0), keep, push);
  }

  /**
   * A random walk.
   *
   * @param first initial value
   * @param rate standard deviation of its change after a second
   * @param step from one step to the next, seconds
   */
  public static CorrelatedNoise walk(RandomStream draws, double first, double rate, double step) {
    return new CorrelatedNoise(draws, first, 1, rate * Math.sqrt(step));
  }

  /**
   * Its value at a step; at the oldest stored step for an older one.
   *
   * @param step the first is 0
   */
  public double at(long step) {
    while (last < step) {
      double before = values[(int) (last % REMEMBERED)];
      last++;
      values[(int) (last % REMEMBERED)] = keep * before + push * draws.gaussian(last);
    }
    long known = Math.max(Math.max(step, 0), last - REMEMBERED + 1);
    return values[(int) (known % REMEMBERED)];
  }
}
