package org.dfra.benchmarks;

import java.io.PrintWriter;
import java.util.Arrays;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.text.PrintableText;

/** The measurements of a benchmark, printed as they are taken. */
final class Report {

  private final PrintWriter out;
  private final RunMeasurements figures = new RunMeasurements();

  Report(PrintWriter out) {
    this.out = out;
  }

  /** Prints a progress message. */
  void say(String sentence) {
    out.println(PrintableText.line(sentence));
    out.flush();
  }

  /** Records a value without a target. */
  void figure(String what, double measured, String unit) {
    figure(what, measured, Double.POSITIVE_INFINITY, unit);
  }

  /** Records a value with an upper target. */
  void figure(String what, double measured, double most, String unit) {
    MeasuredValue figure = new MeasuredValue(what, measured, most, unit);
    figures.add(figure);
    say(figure.line());
  }

  /** All measurements. */
  RunMeasurements figures() {
    return figures;
  }

  /** The quantile for this share of the values; 0.5 gives the median. */
  static double quantile(double[] values, double part) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[Math.min(sorted.length - 1, (int) (part * sorted.length))];
  }
}
