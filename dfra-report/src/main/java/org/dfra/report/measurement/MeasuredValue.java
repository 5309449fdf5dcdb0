package org.dfra.report.measurement;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.dfra.report.terminal.TextWrap;

/**
 * One measured value.
 *
 * @param name what was measured
 * @param value the value
 * @param target its upper limit; infinite if there is none
 * @param unit the unit of both; empty for a plain number
 * @param isTime whether it is a duration that depends on the computer and its load; false if the
 *     target applies on every computer
 */
public record MeasuredValue(String name, double value, double target, String unit, boolean isTime) {

  private static final MathContext SIX = new MathContext(6);
  private static final Set<String> TIMES = Set.of("s", "ms", "µs", "ns");

  /** Columns of the numbers beside the name. */
  private static final int NUMBERS = 43;

  /** Maximum columns of the name. */
  private static final int NAME = 60;

  /**
   * A value that counts as a time if its unit is one, unless its target is 0: "seconds in which two
   * helped at once" is a requirement.
   */
  public MeasuredValue(String what, double measured, double most, String unit) {
    this(what, measured, most, unit, TIMES.contains(unit) && most > 0);
  }

  /** The same value as a requirement, such as the time in which a robot stops. */
  public MeasuredValue asRequired() {
    return new MeasuredValue(name, value, target, unit, false);
  }

  /** Whether it meets its target. */
  public boolean isMet() {
    return value <= target;
  }

  /** Whether it has a target. */
  boolean hasTarget() {
    return target != Double.POSITIVE_INFINITY;
  }

  /** A line of a wide table, marked {@code MISSED} if it misses its target. */
  public String line() {
    return String.join(" ", lines(NAME + NUMBERS));
  }

  /**
   * The same in the given number of columns: the name is wrapped at words, and the numbers are on
   * the last of its lines.
   *
   * @param columns of the terminal; values below 60 count as 60
   */
  public List<String> lines(int columns) {
    int wide = Math.min(NAME, Math.max(60, columns) - NUMBERS);
    List<String> lines = new ArrayList<>();
    List<String> name = TextWrap.wrap(this.name, wide);
    name.subList(0, name.size() - 1).forEach(each -> lines.add("  " + each));
    String last = name.get(name.size() - 1);
    String value =
        "  "
            + TextWrap.padded(last, wide)
            + String.format(Locale.ROOT, " %9s %-3s", text(this.value), unit);
    if (!hasTarget()) {
      lines.add(value.stripTrailing());
      return lines;
    }
    String wanted = "target ≤ " + text(target) + (unit.isEmpty() ? "" : " " + unit);
    lines.add(value + "  " + (isMet() ? wanted : TextWrap.padded(wanted, 16) + " MISSED"));
    return lines;
  }

  /** The value with its unit. */
  String valueText() {
    return (text(value) + " " + unit).strip();
  }

  /** The target with its unit; empty if there is none. */
  String targetText() {
    return hasTarget() ? ("≤ " + text(target) + " " + unit).strip() : "";
  }

  /** A number for CSV files: six digits, without trailing zeros. */
  static String csvNumber(double value) {
    return new BigDecimal(value).round(SIX).stripTrailingZeros().toPlainString();
  }

  /** A number in text output: three decimals, or more if it is small. */
  private static String text(double value) {
    if (value == Math.rint(value) || Math.abs(value) >= 100) {
      return String.format(Locale.ROOT, "%.0f", value);
    }
    return String.format(Locale.ROOT, Math.abs(value) < 0.001 ? "%.3g" : "%.3f", value);
  }
}
