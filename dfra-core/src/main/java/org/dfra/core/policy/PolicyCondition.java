package org.dfra.core.policy;

import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.Optional;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/** A condition of a rule. A rule applies only if all its conditions hold. */
sealed interface PolicyCondition {

  /** Whether it holds now. */
  Truth evaluate(PolicyFacts facts);

  /** The condition as the rest of a sentence that begins with "only". */
  String text();

  /** The robot is inside a region. */
  record Within(PolicyRegion region) implements PolicyCondition {

    @Override
    public Truth evaluate(PolicyFacts facts) {
      Optional<GeoPosition> position = facts.position();
      return position.isEmpty() ? Truth.UNKNOWN : Truth.of(region.contains(position.get()));
    }

    @Override
    public String text() {
      return "within region " + region.name();
    }
  }

  /**
   * The time is in a period.
   *
   * @param from its first instant; null if it has no beginning
   * @param until the first instant after it; null if it has no end
   */
  record During(@Nullable Instant from, @Nullable Instant until) implements PolicyCondition {

    @Override
    public Truth evaluate(PolicyFacts facts) {
      Optional<Instant> time = facts.time();
      return time.isEmpty()
          ? Truth.UNKNOWN
          : Truth.of(
              (from == null || !time.get().isBefore(from))
                  && (until == null || time.get().isBefore(until)));
    }

    @Override
    public String text() {
      return (from == null ? "" : "from " + from)
          + (from == null || until == null ? "" : " ")
          + (until == null ? "" : "until " + until);
    }
  }

  /**
   * The time is in a period of each day, in UTC.
   *
   * @param until the first time after it; if it is before {@code from}, the period includes
   *     midnight
   */
  record Daily(LocalTime from, LocalTime until) implements PolicyCondition {

    @Override
    public Truth evaluate(PolicyFacts facts) {
      Optional<Instant> now = facts.time();
      if (now.isEmpty()) {
        return Truth.UNKNOWN;
      }
      LocalTime time = LocalTime.ofInstant(now.get(), ZoneOffset.UTC);
      boolean isAfterBegin = !time.isBefore(from);
      boolean isBeforeEnd = time.isBefore(until);
      return Truth.of(
          from.isBefore(until) ? isAfterBegin && isBeforeEnd : isAfterBegin || isBeforeEnd);
    }

    @Override
    public String text() {
      return "from " + from + " until " + until + " UTC on each day";
    }
  }

  /** A named fact has a value. */
  record FactIs(String fact, String value) implements PolicyCondition {

    @Override
    public Truth evaluate(PolicyFacts facts) {
      Optional<String> known = facts.fact(fact);
      return known.isEmpty() ? Truth.UNKNOWN : Truth.of(known.get().equals(value));
    }

    @Override
    public String text() {
      return "while " + fact + " is " + value;
    }
  }
}
