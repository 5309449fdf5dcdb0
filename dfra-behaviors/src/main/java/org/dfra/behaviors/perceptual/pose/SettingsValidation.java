package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;

/** Range checks of settings. */
final class SettingsValidation {

  private static final Duration LONGEST = Duration.ofMinutes(2);

  private SettingsValidation() {}

  static void requirePositive(String what, double value) {
    if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(what + " " + value + " is not above 0; give one that is");
    }
  }

  static void requireNonNegative(String what, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(what + " " + value + " is below 0; give 0 or more");
    }
  }

  static void requireDuration(String what, Duration value) {
    if (value.isNegative() || value.isZero() || value.compareTo(LONGEST) > 0) {
      throw new IllegalArgumentException(
          what + " " + value + " is not within 0 to " + LONGEST + "; give one that is");
    }
  }
}
