package org.dfra.report.plot;

/**
 * The quantity along an axis.
 *
 * @param label its name, such as {@code time}
 * @param unit its unit, such as {@code s}; empty if it has none
 * @param low lower end, in this unit; NaN to take it from the data
 * @param high upper end; NaN to take it from the data
 */
public record Axis(String label, String unit, double low, double high) {

  public Axis {
    if (low >= high || Double.isInfinite(low) || Double.isInfinite(high)) {
      throw new IllegalArgumentException(
          "the axis " + label + " from " + low + " to " + high + " is empty; give low < high");
    }
  }

  /** An axis as long as the data need. */
  public static Axis of(String label, String unit) {
    return new Axis(label, unit, Double.NaN, Double.NaN);
  }

  /** The same axis with fixed ends. */
  public Axis between(double low, double high) {
    return new Axis(label, unit, low, high);
  }

  /** {@code time [s]}. */
  public String title() {
    return unit.isEmpty() ? label : label + " [" + unit + "]";
  }

  /** Its fixed ends, and for those that are not fixed, the range's. */
  Range over(Range data) {
    double from = Double.isNaN(low) ? data.low() : low;
    double to = Double.isNaN(high) ? data.high() : high;
    return from < to ? new Range(from, to) : new Range(from, from + 1); // data beyond a fixed end
  }
}
