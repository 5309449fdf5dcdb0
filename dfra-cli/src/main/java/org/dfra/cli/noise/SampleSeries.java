package org.dfra.cli.noise;

import java.util.Arrays;

/** A growing series of numbers and its statistics. */
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

  /** The mean; NaN for an empty series. */
  double mean() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += values[i];
    }
    return sum / size;
  }

  /** The sample standard deviation; NaN for fewer than two numbers. */
  double deviation() {
    double mean = mean();
    double squares = 0;
    for (int i = 0; i < size; i++) {
      squares += (values[i] - mean) * (values[i] - mean);
    }
    return size < 2 ? Double.NaN : Math.sqrt(squares / (size - 1));
  }

  /** The median; NaN for an empty series. */
  double median() {
    double[] sorted = Arrays.copyOf(values, size);
    Arrays.sort(sorted);
    return size == 0 ? Double.NaN : sorted[size / 2];
  }

  /** The difference between each number and the one {@code lag} before it. */
  SampleSeries differences(int lag) {
    SampleSeries differences = new SampleSeries();
    for (int i = lag; i < size; i++) {
      differences.add(values[i] - values[i - lag]);
    }
    return differences;
  }

  /** Autocovariance at this lag, about the mean of all numbers; 0 for too few numbers. */
  double covariance(int lag) {
    double mean = mean();
    double sum = 0;
    for (int i = lag; i < size; i++) {
      sum += (values[i] - mean) * (values[i - lag] - mean);
    }
    return size <= lag ? 0 : sum / (size - lag);
  }
}
