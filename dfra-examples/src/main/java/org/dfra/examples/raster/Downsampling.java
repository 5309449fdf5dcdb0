package org.dfra.examples.raster;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Columns of numbers for plots, downsampled to what a figure can show. The CSV files have all
 * numbers.
 */
final class Downsampling {

  private Downsampling() {}

  /**
   * Every n-th sample, and the last.
   *
   * @return {@code {x, y}}
   */
  static <T> double[][] thinned(
      List<T> all, int each, ToDoubleFunction<T> x, ToDoubleFunction<T> y) {
    int[] kept =
        IntStream.range(0, all.size()).filter(i -> i % each == 0 || i == all.size() - 1).toArray();
    return new double[][] {
      IntStream.of(kept).mapToDouble(i -> x.applyAsDouble(all.get(i))).toArray(),
      IntStream.of(kept).mapToDouble(i -> y.applyAsDouble(all.get(i))).toArray()
    };
  }

  /** How the numbers of one bin are aggregated. */
  enum Bin {
    MIN,
    MEAN
  }

  /**
   * One number for each bin of time that has any; an empty bin interrupts the line.
   *
   * @param width of a bin, seconds
   * @return {@code {time, number}}; a bin's time is its middle
   */
  static <T> double[][] binned(
      List<T> all, double width, Bin bin, ToDoubleFunction<T> time, ToDoubleFunction<T> number) {
    List<double[]> points = new ArrayList<>();
    int at = 0;
    while (at < all.size()) {
      long index = (long) Math.floor(time.applyAsDouble(all.get(at)) / width);
      double least = Double.POSITIVE_INFINITY;
      double sum = 0;
      int count = 0;
      while (at < all.size()
          && (long) Math.floor(time.applyAsDouble(all.get(at)) / width) == index) {
        double value = number.applyAsDouble(all.get(at));
        least = Math.min(least, value);
        sum += value;
        count++;
        at++;
      }
      double middle = (index + 0.5) * width;
      if (!points.isEmpty() && middle - points.get(points.size() - 1)[0] > 1.5 * width) {
        points.add(new double[] {middle, Double.NaN});
      }
      points.add(new double[] {middle, bin == Bin.MIN ? least : sum / count});
    }
    return new double[][] {
      points.stream().mapToDouble(point -> point[0]).toArray(),
      points.stream().mapToDouble(point -> point[1]).toArray()
    };
  }
}
