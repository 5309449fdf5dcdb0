package org.dfra.report.plot;

import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/** An interval of an axis, in the axis's unit; low is below high. */
record Range(double low, double high) {

  /** On shorter axes XChart sets no ticks, and its search for them does not end. */
  private static final double SHORTEST = 1e-7;

  /** The range of these values, slightly widened; 0 to 1 if there are none. Ignores NaN. */
  static Range of(DoubleStream values, double margin) {
    double[] ends = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    values
        .filter(Double::isFinite)
        .forEach(
            value -> {
              ends[0] = Math.min(ends[0], value);
              ends[1] = Math.max(ends[1], value);
            });
    if (ends[0] > ends[1]) {
      return new Range(0, 1);
    }
    double size = Math.max(Math.abs(ends[0]), Math.abs(ends[1]));
    if (ends[1] - ends[0] <= Math.max(SHORTEST, size * 1e-12)) { // all values are equal
      double half = size == 0 ? 0.5 : Math.max(SHORTEST, 0.1 * size);
      return new Range(ends[0] - half, ends[1] + half);
    }
    return new Range(ends[0], ends[1]).widened(1 + 2 * margin);
  }

  double length() {
    return high - low;
  }

  /** Longer by this factor, around the same middle. */
  Range widened(double factor) {
    double middle = (low + high) / 2;
    double half = length() / 2 * factor;
    return new Range(middle - half, middle + half);
  }

  /** The relative position of a value: 0 at the low end, 1 at the high one. */
  double part(double value) {
    return (value - low) / length();
  }

  /**
   * Round numbers in it, evenly spaced.
   *
   * @param most maximum count, at least 2
   */
  double[] ticks(int most) {
    double least = length() / Math.max(2, most);
    double power = Math.pow(10, Math.floor(Math.log10(least)));
    double step =
        power * DoubleStream.of(1, 2, 5, 10).filter(f -> f * power >= least).findFirst().orElse(10);
    long first = (long) Math.ceil(low / step - 1e-9);
    long last = (long) Math.floor(high / step + 1e-9);
    // Divides by an integer if possible, so that 3 · 0.1 is 0.3.
    double parts = Math.rint(1 / step);
    return LongStream.rangeClosed(first, last)
        .mapToDouble(i -> step < 1 ? i / parts : i * step)
        .toArray();
  }
}
