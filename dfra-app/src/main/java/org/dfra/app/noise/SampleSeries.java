package org.dfra.app.noise;

import java.util.Arrays;

/** Numbers one after the other, and how they lie. Grows as needed. */
final class SampleSeries {

  private double[] values = new double[64];
  private int size;

  void add(double value) {
    if (size == values.length) {
      values = Arrays.copyOf(values, 2 * size);
    }
    values[size++] = value;
  }

  int size() {
    return size;
  }

  double get(int i) {
    return values[i];
  }

  /** NaN where there is none. */
  double mean() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += values[i];
    }
    return sum / size;
  }

  /** The standard deviation of what they are drawn from; NaN where there are fewer than two. */
  double deviation() {
    double mean = mean();
    double squares = 0;
    for (int i = 0; i < size; i++) {
      squares += (values[i] - mean) * (values[i] - mean);
    }
    return size < 2 ? Double.NaN : Math.sqrt(squares / (size - 1));
  }

  /** The middle one by size; NaN where there is none. */
  double median() {
    double[] sorted = Arrays.copyOf(values, size);
    Arrays.sort(sorted);
    return size == 0 ? Double.NaN : sorted[size / 2];
  }

  /** What each is more than the one so many before it. */
  SampleSeries differences(int lag) {
    SampleSeries differences = new SampleSeries();
    for (int i = lag; i < size; i++) {
      differences.add(values[i] - values[i - lag]);
    }
    return differences;
  }

  /** Covariance with those so many later, about the mean of all; 0 where there are too few. */
  double covariance(int lag) {
    double mean = mean();
    double sum = 0;
    for (int i = lag; i < size; i++) {
      sum += (values[i] - mean) * (values[i - lag] - mean);
    }
    return size <= lag ? 0 : sum / (size - lag);
  }
}
