package org.dfra.app.figure;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;

/**
 * One measured figure.
 *
 * @param what what was measured
 * @param measured the value
 * @param most the most it should be; infinite where it is only stated
 * @param unit the unit of both; empty for a plain number
 */
public record Figure(String what, double measured, double most, String unit) {

  private static final MathContext SIX = new MathContext(6);

  /** Whether it is what it should be. */
  public boolean isMet() {
    return measured <= most;
  }

  /** Whether anything is wanted of it. */
  boolean isBounded() {
    return most != Double.POSITIVE_INFINITY;
  }

  /** A line of a table, marked {@code MISSED} where it is not what it should be. */
  public String line() {
    String value =
        String.format(Locale.ROOT, "  %-60s %9s %-3s", what, text(measured), unit).stripTrailing();
    if (!isBounded()) {
      return value;
    }
    String wanted = "wanted ≤ " + text(most) + (unit.isEmpty() ? "" : " " + unit);
    return String.format(Locale.ROOT, "%-76s   %s%s", value, wanted, isMet() ? "" : "   MISSED");
  }

  /** A number for CSV files: six digits, without zeros at the end. */
  static String exact(double value) {
    return new BigDecimal(value).round(SIX).stripTrailingZeros().toPlainString();
  }

  /** A number for people: three digits after the point, or more where it is small. */
  private static String text(double value) {
    if (value == Math.rint(value) || Math.abs(value) >= 100) {
      return String.format(Locale.ROOT, "%.0f", value);
    }
    return String.format(Locale.ROOT, Math.abs(value) < 0.001 ? "%.3g" : "%.3f", value);
  }
}
