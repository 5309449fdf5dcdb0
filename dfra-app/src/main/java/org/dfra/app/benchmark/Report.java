package org.dfra.app.benchmark;

import java.io.PrintWriter;
import java.util.Arrays;
import org.dfra.app.measurement.MeasuredValue;
import org.dfra.app.measurement.RunMeasurements;
import org.dfra.text.PrintableText;

/** What a benchmark has measured, printed as it comes. */
final class Report {

  private final PrintWriter out;
  private final RunMeasurements figures = new RunMeasurements();

  Report(PrintWriter out) {
    this.out = out;
  }

  /** Says what is being done. */
  void say(String sentence) {
    out.println(PrintableText.line(sentence));
    out.flush();
  }

  /** Notes a figure that is only stated. */
  void figure(String what, double measured, String unit) {
    figure(what, measured, Double.POSITIVE_INFINITY, unit);
  }

  /** Notes a figure that should be at most so much. */
  void figure(String what, double measured, double most, String unit) {
    MeasuredValue figure = new MeasuredValue(what, measured, most, unit);
    figures.add(figure);
    say(figure.line());
  }

  /** All of them. */
  RunMeasurements figures() {
    return figures;
  }

  /** The value that this part of all values does not exceed; 0.5 gives the median. */
  static double quantile(double[] values, double part) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[Math.min(sorted.length - 1, (int) (part * sorted.length))];
  }
}
