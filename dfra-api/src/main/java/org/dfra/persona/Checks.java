package org.dfra.persona;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** What the records of this package have in common: they are small, checked, and comparable. */
final class Checks {

  private Checks() {}

  static void text(String what, String value) {
    if (value.isBlank()) {
      throw new IllegalArgumentException(what + " is blank; give it at least one letter");
    }
  }

  static void finite(String what, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(what + " " + value + " is not a finite number");
    }
  }

  /** Equal sets become equal lists, in whichever order they were given. */
  static List<String> sorted(List<String> texts) {
    return texts.stream().distinct().sorted().toList();
  }

  static @Nullable Instant millis(@Nullable Instant instant) {
    return instant == null ? null : instant.truncatedTo(ChronoUnit.MILLIS);
  }
}
