package org.dfra.persona;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Validation shared by the records of this package. */
final class AttributeValidation {

  private AttributeValidation() {}

  static void requireText(String what, String value) {
    if (value.isBlank()) {
      throw new IllegalArgumentException(what + " is blank; give it at least one letter");
    }
  }

  static void requireFinite(String what, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(what + " " + value + " is not a finite number");
    }
  }

  static void requirePositive(String what, double value, String unit) {
    if (!(value > 0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(what + " " + value + " " + unit + " is not > 0");
    }
  }

  static void requireValidPower(@Nullable Double power) {
    if (power != null && !(power >= 0)) {
      throw new IllegalArgumentException("power " + power + " W is not ≥ 0");
    }
  }

  static void requireFraction(String what, @Nullable Double share) {
    if (share != null && !(share >= 0 && share <= 1)) {
      throw new IllegalArgumentException(what + " " + share + " is outside 0 to 1");
    }
  }

  /**
   * Sorts and removes duplicates, so that equal sets become equal lists.
   *
   * @throws IllegalArgumentException if an element of a received list is not a text: computing its
   *     hash code could take forever
   */
  static List<String> sortedDistinct(List<String> texts) {
    for (Object each : texts) {
      if (!(each instanceof String)) {
        throw new IllegalArgumentException(
            "a list of texts holds "
                + (each == null ? "null" : "a " + each.getClass().getName())
                + "; give texts only");
      }
    }
    return texts.stream().distinct().sorted().toList();
  }

  static @Nullable Instant truncatedToMillis(@Nullable Instant instant) {
    return instant == null ? null : instant.truncatedTo(ChronoUnit.MILLIS);
  }
}
