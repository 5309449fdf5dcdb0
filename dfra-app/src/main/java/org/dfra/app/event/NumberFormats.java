package org.dfra.app.event;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import org.jspecify.annotations.Nullable;

/** Formats of measured numbers. */
final class NumberFormats {

  private static final double KILO = 1000;
  private static final MathContext FOUR = new MathContext(4, RoundingMode.HALF_EVEN);

  private NumberFormats() {}

  /** The number; null for NaN. */
  static @Nullable Double orNull(double number) {
    return Double.isFinite(number) ? number : null;
  }

  /** {@code 0.9998}, {@code 12.35}, {@code 12350}. */
  static String fourDigits(double number) {
    return Double.isFinite(number)
        ? new BigDecimal(number).round(FOUR).toPlainString()
        : "an unknown number of";
  }

  /** {@code 812 B}, {@code 1.234 kB}, {@code 12.35 MB}: a kilobyte has 1000 bytes. */
  static String bytes(double bytes) {
    if (bytes < KILO) {
      return fourDigits(bytes) + " B";
    }
    return bytes < KILO * KILO
        ? fourDigits(bytes / KILO) + " kB"
        : fourDigits(bytes / KILO / KILO) + " MB";
  }
}
