package org.dfra.event.delivery;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.event.ModuleEvent;
import org.jspecify.annotations.Nullable;

/**
 * Estimates the size of an event in a call without serializing it: for records of numbers, texts,
 * values of the JDK, arrays, lists and other such records. These are all readings of DFRA. Others
 * may contain what a call limits by other measures than bytes, such as hash tables.
 */
final class EventSize {

  /** The size of an event of another kind: such an event is delivered alone. */
  static final long UNKNOWN = Long.MAX_VALUE;

  private static final int OBJECT = 16;
  private static final int NUMBER = 8;
  private static final int MAX_DEPTH = 8;

  /** The fields of a record that has only such fields as can be read; null for another class. */
  private static final ClassValue<@Nullable List<Field>> FIELDS =
      new ClassValue<>() {
        @Override
        protected @Nullable List<Field> computeValue(Class<?> type) {
          return type.isRecord() ? fields(type) : null;
        }
      };

  private EventSize() {}

  /** The estimated bytes of an event, or {@link #UNKNOWN}. */
  static long of(ModuleEvent event) {
    return of(event, 0);
  }

  private static @Nullable List<Field> fields(Class<?> type) {
    List<Field> fields = new ArrayList<>();
    for (Field field : type.getDeclaredFields()) {
      if (Modifier.isStatic(field.getModifiers())) {
        continue;
      }
      if (!field.trySetAccessible()) {
        return null;
      }
      fields.add(field);
    }
    return fields;
  }

  private static long of(@Nullable Object value, int depth) {
    if (value == null || value instanceof Number || value instanceof Boolean) {
      return NUMBER;
    }
    if (value instanceof String text) {
      return OBJECT + text.length();
    }
    Class<?> type = value.getClass();
    if (value instanceof Enum || type.getPackageName().equals("java.time")) {
      return OBJECT;
    }
    if (depth == MAX_DEPTH) {
      return UNKNOWN;
    }
    if (type.isArray()) {
      return array(value, type.getComponentType(), depth);
    }
    if (value instanceof Optional<?> optional) {
      return of(optional.orElse(null), depth + 1);
    }
    if (value instanceof List<?> all) {
      long sum = OBJECT;
      for (Object each : all) {
        sum = sum(sum, of(each, depth + 1));
      }
      return sum;
    }
    return record(value, FIELDS.get(type), depth);
  }

  private static long array(Object array, Class<?> element, int depth) {
    int length = Array.getLength(array);
    if (element == byte.class || element == boolean.class) {
      return OBJECT + length;
    }
    if (element.isPrimitive()) {
      return OBJECT + (long) NUMBER * length;
    }
    long sum = OBJECT;
    for (int i = 0; i < length && sum != UNKNOWN; i++) {
      sum = sum(sum, of(Array.get(array, i), depth + 1));
    }
    return sum;
  }

  private static long record(Object value, @Nullable List<Field> fields, int depth) {
    if (fields == null) {
      return UNKNOWN;
    }
    long sum = OBJECT;
    try {
      for (Field field : fields) {
        sum = sum(sum, field.getType().isPrimitive() ? NUMBER : of(field.get(value), depth + 1));
      }
    } catch (IllegalAccessException e) {
      return UNKNOWN;
    }
    return sum;
  }

  private static long sum(long one, long other) {
    return one == UNKNOWN || other == UNKNOWN ? UNKNOWN : one + other;
  }
}
