package org.dfra.app.plot;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as people read them, at axes and elsewhere. */
public final class Numerals {

  private static final MathContext DIGITS = new MathContext(10);

  private Numerals() {}

  /** With ten digits at most, and a power of ten where it is very large or small. */
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
