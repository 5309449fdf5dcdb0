package org.dfra.app.raster;

import java.util.Arrays;

/**
 * Statistics of distances; NaN if there were none.
 *
 * @param mean of the distances, metres
 * @param rms root mean square, metres
 * @param within95 95th percentile, metres
 * @param most maximum, metres
 */
public record Deviation(double mean, double rms, double within95, double most) {

  private static final double MOST_OF_THEM = 0.95;

  /** Statistics of distances in metres; their signs are ignored. */
  public static Deviation of(double... distances) {
    if (distances.length == 0) {
      return new Deviation(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }
    double[] sorted = Arrays.stream(distances).map(Math::abs).sorted().toArray();
    double squares = Arrays.stream(sorted).map(each -> each * each).sum();
    int rank = (int) Math.ceil(MOST_OF_THEM * sorted.length); // the nearest-rank percentile
    return new Deviation(
        Arrays.stream(sorted).average().orElse(Double.NaN),
        Math.sqrt(squares / sorted.length),
        sorted[rank - 1],
        sorted[sorted.length - 1]);
  }
}
