package org.dfra.directory;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * A condition on one component of an attribute record. An unknown value, null, meets no condition.
 */
public sealed interface Condition {

  /** Equal to a value; numbers are compared as numbers, whatever their types. */
  static Condition equalTo(Object value) {
    return new EqualTo(value);
  }

  /** A number not below {@code min}. */
  static Condition atLeast(double min) {
    return new InRange(min, Double.POSITIVE_INFINITY);
  }

  /** A number not above {@code max}. */
  static Condition atMost(double max) {
    return new InRange(Double.NEGATIVE_INFINITY, max);
  }

  /** A number from {@code min} to {@code max}, both included. */
  static Condition between(double min, double max) {
    return new InRange(min, max);
  }

  /** A list of texts that contains this text, or a text that contains it as a substring. */
  static Condition contains(String text) {
    return new Containing(text);
  }

  /** Whether a component's value meets the condition. */
  boolean test(@Nullable Object value);

  /** Why this condition does not apply to a component of that type; null if it applies. */
  @Nullable String validationError(Class<?> type);

  /** See {@link #equalTo}. */
  record EqualTo(Object value) implements Condition {
    @Override
    public boolean test(@Nullable Object found) {
      return found instanceof Number one && value instanceof Number other
          ? one.doubleValue() == other.doubleValue()
          : value.equals(found);
    }

    @Override
    public @Nullable String validationError(Class<?> type) {
      Class<?> boxed = boxed(type);
      boolean fits =
          boxed.isInstance(value)
              || (Number.class.isAssignableFrom(boxed) && value instanceof Number);
      return fits
          ? null
          : "is a "
              + boxed.getSimpleName()
              + " and never equals the "
              + value.getClass().getSimpleName()
              + " "
              + value;
    }

    /** Compares numbers as numbers, as {@link Condition#equalTo} does. */
    @Override
    public boolean equals(@Nullable Object other) {
      if (!(other instanceof EqualTo that)) {
        return false;
      }
      return value instanceof Number one && that.value instanceof Number another
          ? Double.compare(one.doubleValue(), another.doubleValue()) == 0
          : value.equals(that.value);
    }

    @Override
    public int hashCode() {
      return value instanceof Number number
          ? Double.hashCode(number.doubleValue())
          : value.hashCode();
    }

    @Override
    public String toString() {
      return "= " + QueryFormatter.value(value);
    }
  }

  /** See {@link #between}; an infinite end is no limit. */
  record InRange(double min, double max) implements Condition {

    public InRange {
      if (!(min <= max)) {
        throw new IllegalArgumentException(
            "no number is at least " + min + " and at most " + max + "; exchange the two");
      }
    }

    @Override
    public boolean test(@Nullable Object found) {
      return found instanceof Number number
          && number.doubleValue() >= min
          && number.doubleValue() <= max;
    }

    @Override
    public @Nullable String validationError(Class<?> type) {
      Class<?> boxed = boxed(type);
      return Number.class.isAssignableFrom(boxed)
          ? null
          : "is a " + boxed.getSimpleName() + " and has no range; only numbers do";
    }

    @Override
    public String toString() {
      if (min == Double.NEGATIVE_INFINITY) {
        return "≤ " + max;
      }
      return max == Double.POSITIVE_INFINITY ? "≥ " + min : "from " + min + " to " + max;
    }
  }

  /** See {@link #contains}. */
  record Containing(String text) implements Condition {
    @Override
    public boolean test(@Nullable Object found) {
      return found instanceof String string
          ? string.contains(text)
          : found instanceof List<?> list && list.contains(text);
    }

    @Override
    public @Nullable String validationError(Class<?> type) {
      return type == String.class || type == List.class
          ? null
          : "is a "
              + boxed(type).getSimpleName()
              + " and contains nothing; only texts and lists do";
    }

    @Override
    public String toString() {
      return "contains " + QueryFormatter.quoted(text);
    }
  }

  private static Class<?> boxed(Class<?> type) {
    return Map.<Class<?>, Class<?>>of(
            int.class, Integer.class,
            long.class, Long.class,
            double.class, Double.class,
            float.class, Float.class,
            short.class, Short.class,
            byte.class, Byte.class,
            boolean.class, Boolean.class,
            char.class, Character.class)
        .getOrDefault(type, type);
  }
}
