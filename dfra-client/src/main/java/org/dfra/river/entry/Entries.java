package org.dfra.river.entry;

import java.lang.System.Logger.Level;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import net.jini.core.entry.Entry;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.jspecify.annotations.Nullable;

/** Converts attribute records to entries and entries to attribute records. */
public final class Entries {

  private static final System.Logger LOG = System.getLogger(Entries.class.getName());

  /** Every entry class of this package that mirrors a record, a subclass before its superclass. */
  private static final List<Class<? extends Entry>> KINDS =
      List.of(
          SensorEntry.class,
          EffectorEntry.class,
          PerceptualSchemaEntry.class,
          MotorSchemaEntry.class,
          BehaviorEntry.class,
          ChainableEntry.class,
          ModuleEntry.class,
          PoseEntry.class,
          LocationEntry.class,
          GPSEntry.class,
          PersonaEntry.class);

  private Entries() {}

  /** Every entry class that modules here may use, without its superclasses. */
  public static List<Class<?>> entryClasses() {
    List<Class<?>> kinds = new ArrayList<>(KnownEntryClasses.ALL);
    kinds.add(RecordEntry.class);
    return kinds;
  }

  /** All known entry classes; searched at the first conversion. */
  private static final class KnownEntryClasses {

    static final List<Class<? extends Entry>> ALL = all();

    private static List<Class<? extends Entry>> all() {
      List<Class<? extends Entry>> all = new ArrayList<>();
      for (EntryClassProvider brought :
          ServiceLoader.load(EntryClassProvider.class, Entries.class.getClassLoader())) {
        for (Class<? extends Entry> kind : brought.entryClasses()) {
          if (mirrored(kind) == null) {
            throw new IllegalStateException(
                brought.getClass().getName()
                    + " brings "
                    + kind.getName()
                    + ", which mirrors no record; annotate it with @Mirrors");
          }
          all.add(kind);
        }
      }
      all.addAll(KINDS);
      return List.copyOf(all);
    }
  }

  /**
   * Converts records to entries. Records whose entry classes are super- and subclass of each other
   * share one entry.
   *
   * @throws IllegalArgumentException if there are two records of one type, or one has a value that
   *     no entry can hold
   */
  public static Entry[] toEntries(List<? extends Attributes> attributes) {
    Map<Class<?>, Attributes> left = new LinkedHashMap<>();
    for (Attributes each : attributes) {
      if (left.put(each.getClass(), each) != null) {
        throw new IllegalArgumentException(
            "there are two records of type " + each.getClass().getSimpleName() + "; give one");
      }
    }
    List<Entry> entries = new ArrayList<>();
    for (Class<? extends Entry> kind : KnownEntryClasses.ALL) {
      if (left.containsKey(mirrored(kind))) {
        entries.add(entry(kind, left));
      }
    }
    left.values().forEach(record -> entries.add(RecordEntryCodec.encode(record)));
    return entries.toArray(Entry[]::new);
  }

  private static Entry entry(Class<? extends Entry> kind, Map<Class<?>, Attributes> left) {
    try {
      Entry entry = kind.getConstructor().newInstance();
      for (@Nullable Class<?> type = kind; type != null; type = type.getSuperclass()) {
        @Nullable Attributes record = left.remove(mirrored(type));
        if (record != null) {
          for (RecordComponent component : record.getClass().getRecordComponents()) {
            Field field = type.getDeclaredField(component.getName());
            field.set(entry, toField(component.getAccessor().invoke(record)));
          }
        }
      }
      return entry;
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(kind + " does not mirror its record", e);
    }
  }

  /**
   * Converts entries to the records that this client knows. It omits entries of other kinds, such
   * as River's own, and those without a required value.
   */
  public static List<Attributes> toAttributes(@Nullable Entry @Nullable [] entries) {
    List<Attributes> records = new ArrayList<>();
    if (entries == null) {
      return records;
    }
    for (@Nullable Entry entry : entries) {
      if (entry instanceof RecordEntry text) {
        RecordEntryCodec.decode(text).ifPresent(records::add);
      } else if (entry != null) {
        for (@Nullable Class<?> type = entry.getClass();
            type != null;
            type = type.getSuperclass()) {
          @Nullable Class<? extends Attributes> mirrored = mirrored(type);
          if (mirrored != null) {
            @Nullable Attributes record = record(mirrored, type, entry);
            if (record != null) {
              records.add(record);
            }
          }
        }
      }
    }
    return List.copyOf(records);
  }

  private static @Nullable Attributes record(
      Class<? extends Attributes> mirrored, Class<?> type, Entry entry) {
    try {
      RecordComponent[] components = mirrored.getRecordComponents();
      @Nullable Object[] values = new @Nullable Object[components.length];
      boolean any = false;
      for (int i = 0; i < values.length; i++) {
        @Nullable Object value = type.getDeclaredField(components[i].getName()).get(entry);
        any |= value != null;
        values[i] =
            toComponent(
                value == null ? unknown(mirrored, components[i]) : value, components[i].getType());
      }
      return any ? make(mirrored, values) : null;
    } catch (NoSuchFieldException | IllegalAccessException e) {
      throw new AssertionError(type + " does not mirror its record", e);
    }
  }

  /** The record, or null if its constructor refuses the values. */
  static <A extends Attributes> @Nullable A make(Class<A> type, @Nullable Object[] values) {
    Class<?>[] types = new Class<?>[values.length];
    RecordComponent[] components = type.getRecordComponents();
    for (int i = 0; i < types.length; i++) {
      types[i] = components[i].getType();
      if (types[i].isPrimitive() && values[i] == null) {
        LOG.log(
            Level.DEBUG,
            "{0} without {1} is left out.",
            type.getSimpleName(),
            components[i].getName());
        return null;
      }
    }
    try {
      return type.getDeclaredConstructor(types).newInstance(values);
    } catch (InvocationTargetException | IllegalArgumentException e) {
      LOG.log(Level.DEBUG, "A " + type.getSimpleName() + " that is none is left out.", e);
      return null;
    } catch (ReflectiveOperationException e) {
      LOG.log(Level.DEBUG, "A " + type.getSimpleName() + " cannot be made here.", e);
      return null;
    }
  }

  /**
   * The value of a module's attribute that a lookup service does not show to this client: a policy
   * may hide all but the names and the state. Null for other attributes.
   */
  private static @Nullable Object unknown(
      Class<? extends Attributes> mirrored, RecordComponent component) {
    if (mirrored != ModuleAttributes.class) {
      return null;
    }
    return switch (component.getName()) {
      case "driver", "host", "author", "version" -> "";
      case "created" -> 0L;
      case "clients" -> 0;
      default -> null;
    };
  }

  private static @Nullable Object toField(@Nullable Object value) {
    if (value instanceof Instant instant) {
      return instant.toEpochMilli();
    }
    // Always this class: a registrar compares bytes, and List.of has another serial form.
    return value instanceof List<?> list ? new ArrayList<>(list) : value;
  }

  private static @Nullable Object toComponent(@Nullable Object value, Class<?> type) {
    if (value instanceof Long millis && type == Instant.class) {
      return Instant.ofEpochMilli(millis);
    }
    return value;
  }

  /** Whether records of a type have an entry class of this package. */
  static boolean hasEntryClass(Class<?> record) {
    return KINDS.stream().anyMatch(kind -> record == mirrored(kind));
  }

  private static @Nullable Class<? extends Attributes> mirrored(Class<?> type) {
    @Nullable Mirrors mirrors = type.getAnnotation(Mirrors.class);
    return mirrors == null ? null : mirrors.value();
  }
}
