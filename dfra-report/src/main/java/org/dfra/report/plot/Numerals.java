package org.dfra.report.plot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.regex.Pattern;

/** Numbers as text, for axes and tables. */
public final class Numerals {

  private static final MathContext DIGITS = new MathContext(10);

  /** A number, perhaps with a sign, a second number after ± or an interval, and a unit. */
  private static final Pattern NUMBER =
      Pattern.compile(
          "[≤≥<>~]?\\s?[-+−]?\\d[\\d.,]*(?:e[-−]?\\d+)?(?: \\([-−\\d.]+ to [-−\\d.]+\\))?"
              + "(?:[ \u00a0](?:[^\\d\\s]\\S{0,5}|±.{1,12}))*");

  /** Between a number and its unit. */
  private static final Pattern BREAK =
      Pattern.compile(
          "(?<=\\d) (?=(?:[kmµn]?[smgVAW]|[cm]m²?|m²|m/s|rad/s|rad|Hz|kHz|%|°|dB|min|h)(?![\\w/]))");

  private static final Pattern SIGN = Pattern.compile("(?<=[≤≥±]) (?=\\d)");

  private Numerals() {}

  /** The text with non-breaking spaces between numbers and their units. */
  public static String unbroken(String text) {
    return SIGN.matcher(BREAK.matcher(text).replaceAll("\u00a0")).replaceAll("\u00a0");
  }

  /** Whether most cells of a column are numbers, so that it is right-aligned. */
  static boolean areNumbers(List<String> cells) {
    long filled = cells.stream().filter(each -> !each.isBlank() && !each.equals("-")).count();
    long numbers = cells.stream().filter(each -> NUMBER.matcher(each).matches()).count();
    return numbers > 0 && 2 * numbers > filled;
  }

  /** With ten digits at most, and a power of ten if it is very large or small. */
  public static String of(double value) {
    BigDecimal number = new BigDecimal(value).round(DIGITS).stripTrailingZeros();
    if (number.signum() == 0) {
      return "0";
    }
    int power = number.precision() - number.scale() - 1;
    if (power >= -4 && power <= 9) {
      return number.toPlainString().replace('-', '−');
    }
    String digits = number.movePointLeft(power).toPlainString();
    return (digits + "e" + power).replace('-', '−');
  }
}
