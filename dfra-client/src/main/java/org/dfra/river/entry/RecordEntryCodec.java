package org.dfra.river.entry;

import java.lang.reflect.RecordComponent;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.persona.Attributes;
import org.dfra.river.filter.ClassLookup;
import org.jspecify.annotations.Nullable;

/** Encodes a record as strings, and decodes it. */
final class RecordEntryCodec {

  private RecordEntryCodec() {}

  static RecordEntry encode(Attributes record) {
    RecordEntry entry = new RecordEntry();
    entry.type = record.getClass().getName();
    List<String> values = new ArrayList<>();
    if (!record.getClass().isRecord()) {
      throw new IllegalArgumentException(entry.type + " is not a record; attributes are records");
    }
    for (RecordComponent component : record.getClass().getRecordComponents()) {
      for (Object value : all(value(record, component))) {
        values.add(component.getName() + "=" + text(value, record, component));
      }
    }
    values.sort(null);
    entry.values = values;
    return entry;
  }

  private static @Nullable Object value(Attributes record, RecordComponent component) {
    try {
      component.getAccessor().setAccessible(true);
      return component.getAccessor().invoke(record);
    } catch (ReflectiveOperationException | RuntimeException e) {
      throw new IllegalArgumentException(
          record.getClass().getName() + " cannot be read; make the record public", e);
    }
  }

  private static List<?> all(@Nullable Object value) {
    return value == null ? List.of() : value instanceof List<?> list ? list : List.of(value);
  }

  private static String text(Object value, Attributes record, RecordComponent component) {
    if (value instanceof Instant instant) {
      return Long.toString(instant.toEpochMilli());
    } else if (value instanceof Enum<?> constant) {
      return constant.name();
    } else if (value instanceof String || value instanceof Number || value instanceof Boolean) {
      return value.toString();
    }
    throw new IllegalArgumentException(
        record.getClass().getSimpleName()
            + "."
            + component.getName()
            + " is a "
            + value.getClass().getSimpleName()
            + "; an attribute is a text, a number, a boolean, an enum, an instant or a list of"
            + " texts");
  }

  /** The record; empty if its class is unknown here or does not fit. */
  static Optional<Attributes> decode(RecordEntry entry) {
    List<String> texts = entry.values;
    Class<? extends Attributes> type = type(entry.type);
    if (type == null || texts == null) {
      return Optional.empty();
    }
    RecordComponent[] components = type.getRecordComponents();
    @Nullable Object[] values = new @Nullable Object[components.length];
    try {
      for (int i = 0; i < values.length; i++) {
        String prefix = components[i].getName() + "=";
        List<String> found =
            texts.stream()
                .filter(each -> each.startsWith(prefix))
                .map(each -> each.substring(prefix.length()))
                .toList();
        values[i] = parse(found, components[i].getType());
      }
    } catch (DateTimeException | IllegalArgumentException e) {
      return Optional.empty();
    }
    return Optional.ofNullable(Entries.make(type, values));
  }

  private static @Nullable Class<? extends Attributes> type(@Nullable String name) {
    if (name == null) {
      return null;
    }
    @Nullable ClassLoader context = Thread.currentThread().getContextClassLoader();
    try {
      Class<?> type =
          ClassLookup.find(
              name, context != null ? context : RecordEntryCodec.class.getClassLoader());
      // A record with an entry class must use it: a registrar checks which robot those entries
      // name.
      return type.isRecord()
              && Attributes.class.isAssignableFrom(type)
              && !Entries.hasEntryClass(type)
          ? type.asSubclass(Attributes.class)
          : null;
    } catch (ClassNotFoundException | LinkageError e) {
      return null;
    }
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // any enum
  private static @Nullable Object parse(List<String> found, Class<?> type) {
    if (type == List.class) {
      return found;
    } else if (found.isEmpty()) {
      return null;
    }
    String text = found.get(0);
    if (type == String.class) {
      return text;
    } else if (type == Instant.class) {
      return Instant.ofEpochMilli(Long.parseLong(text));
    } else if (type.isEnum()) {
      return Enum.valueOf((Class<Enum>) type, text);
    } else if (type == boolean.class || type == Boolean.class) {
      return Boolean.valueOf(text);
    } else if (type == int.class || type == Integer.class) {
      return Integer.valueOf(text);
    } else if (type == long.class || type == Long.class) {
      return Long.valueOf(text);
    } else if (type == double.class || type == Double.class) {
      return Double.valueOf(text);
    } else if (type == float.class || type == Float.class) {
      return Float.valueOf(text);
    } else if (type == short.class || type == Short.class) {
      return Short.valueOf(text);
    } else if (type == byte.class || type == Byte.class) {
      return Byte.valueOf(text);
    }
    throw new IllegalArgumentException("no attribute is a " + type);
  }
}
