package org.dfra.app.measurement;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.dfra.app.terminal.TextWrap;

/**
 * One measured figure.
 *
 * @param name what was measured
 * @param value the value
 * @param target the most it should be; infinite where it is only stated
 * @param unit the unit of both; empty for a plain number
 * @param isTime whether it is how long something took, which depends on the computer and on what
 *     else that does; false for what must be true on every computer
 */
public record MeasuredValue(String name, double value, double target, String unit, boolean isTime) {

  private static final MathContext SIX = new MathContext(6);
  private static final Set<String> TIMES = Set.of("s", "ms", "µs", "ns");

  /** Columns that the numbers take beside what was measured. */
  private static final int NUMBERS = 43;

  /** Columns of what was measured, where there is room. */
  private static final int NAME = 60;

  /**
   * A figure that is a time where its unit is one, unless it must be 0: "seconds in which two
   * helped at once" must be true.
   */
  public MeasuredValue(String what, double measured, double most, String unit) {
    this(what, measured, most, unit, TIMES.contains(unit) && most > 0);
  }

  /** The same as something that must be true, such as the time in which a robot stops. */
  public MeasuredValue asRequired() {
    return new MeasuredValue(name, value, target, unit, false);
  }

  /** Whether it is what it should be. */
  public boolean isMet() {
    return value <= target;
  }

  /** Whether anything is wanted of it. */
  boolean hasTarget() {
    return target != Double.POSITIVE_INFINITY;
  }

  /** A line of a wide table, marked {@code MISSED} where it is not what it should be. */
  public String line() {
    return String.join(" ", lines(NAME + NUMBERS));
  }

  /**
   * The same in so many columns: what was measured is folded by word, and the numbers stand beside
   * the last of its lines.
   *
   * @param columns of the terminal; below 60 is taken as 60
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
    String wanted = "wanted ≤ " + text(target) + (unit.isEmpty() ? "" : " " + unit);
    lines.add(value + "  " + (isMet() ? wanted : TextWrap.padded(wanted, 16) + " MISSED"));
    return lines;
  }

  /** What was measured, with its unit. */
  String valueText() {
    return (text(value) + " " + unit).strip();
  }

  /** What is wanted, with its unit; empty where nothing is. */
  String targetText() {
    return hasTarget() ? ("≤ " + text(target) + " " + unit).strip() : "";
  }

  /** A number for CSV files: six digits, without zeros at the end. */
  static String csvNumber(double value) {
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
