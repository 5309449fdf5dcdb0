package org.dfra.river.registrar;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import net.jini.core.entry.Entry;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.entry.PersonaEntry;
import org.dfra.river.filter.ClassLookup;
import org.jspecify.annotations.Nullable;

/**
 * Determines which robot the marshalled entries of a registration name. It instantiates no entry,
 * since that would download a class.
 *
 * <p>Reggie sends the class of an entry and its fields, superclass first, by name within a class.
 * Strings are sent as they are, all other objects marshalled.
 */
final class RobotClaimReader {

  private static final Map<Class<?>, Integer> ROBOT =
      Map.of(
          ModuleEntry.class, index(ModuleEntry.class, "robot"),
          PersonaEntry.class, index(PersonaEntry.class, "robot"));

  private static final int HOST = index(ModuleEntry.class, "host");
  private static final int NAME = index(ModuleEntry.class, "name");

  private final Field entryClass;
  private final Field fields;
  private final EntryDescriptorReader descriptors;

  /**
   * @param loader of reggie's classes
   * @throws ReflectiveOperationException if that is not reggie 2.2.2
   */
  RobotClaimReader(@Nullable ClassLoader loader, EntryDescriptorReader descriptors)
      throws ReflectiveOperationException {
    Class<?> entry = Class.forName("com.sun.jini.reggie.EntryRep", false, loader);
    entryClass = ReggieFields.accessible(entry, "eclass");
    fields = ReggieFields.accessible(entry, "fields");
    this.descriptors = descriptors;
  }

  /** The index of a field of an entry without superclass fields. */
  private static int index(Class<? extends Entry> type, String field) {
    List<String> names =
        Arrays.stream(type.getDeclaredFields())
            .filter(each -> Modifier.isPublic(each.getModifiers()))
            .filter(each -> !Modifier.isStatic(each.getModifiers()))
            .map(Field::getName)
            .sorted(Comparator.naturalOrder())
            .toList();
    int index = names.indexOf(field);
    if (index < 0) {
      throw new AssertionError(type + " has no field " + field);
    }
    return index;
  }

  /**
   * Whether entries name a robot as the one that they belong to. The result is also true for two
   * entries that cannot be checked. One is an entry of a DFRA class whose robot is no string. The
   * other has the robot's name in any field, and its class is unknown here or differs from the
   * local one: it may extend a DFRA class.
   *
   * @param entries reggie's form of entries; null for none
   */
  boolean anyNamesRobot(Object @Nullable [] entries, String robot) {
    if (entries != null) {
      for (Object each : entries) {
        if (each != null && names(each, robot)) {
          return true;
        }
      }
    }
    return false;
  }

  /**
   * Whether a change could make an entry name a robot. Reggie puts the fields of a change into each
   * matching entry, and trusts the client on the class of both.
   *
   * @param changes reggie's form of the changes; null for none
   */
  boolean changeMayNameRobot(Object @Nullable [] changes, String robot) {
    if (changes != null) {
      for (Object each : changes) {
        if (each != null && (names(each, robot) || hasInPlace(values(each), robot))) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean hasInPlace(@Nullable Object[] values, String robot) {
    return ROBOT.values().stream().anyMatch(at -> at < values.length && robot.equals(values[at]));
  }

  private boolean names(Object entry, String robot) {
    @Nullable Object[] values = values(entry);
    @Nullable Class<?> type = type(entry);
    if (type == null) {
      return Arrays.asList(values).contains(robot);
    }
    @Nullable Integer at = null;
    for (@Nullable Class<?> each = type; each != null && at == null; each = each.getSuperclass()) {
      at = ROBOT.get(each);
    }
    if (at == null) {
      return false;
    }
    @Nullable Object value = at < values.length ? values[at] : null;
    return value instanceof String text ? text.equals(robot) : at >= values.length || value != null;
  }

  /** The host in the entries of a module; null if they have none. */
  @Nullable String host(Object @Nullable [] entries) {
    return text(entries, ModuleEntry.class, HOST);
  }

  /** The name in the entries of a module; null if they have none. */
  @Nullable String name(Object @Nullable [] entries) {
    return text(entries, ModuleEntry.class, NAME);
  }

  /** The robot in the entries of a module or of a robot; null if they have none. */
  @Nullable String robot(Object @Nullable [] entries) {
    for (Map.Entry<Class<?>, Integer> each : ROBOT.entrySet()) {
      @Nullable String robot = text(entries, each.getKey(), each.getValue());
      if (robot != null) {
        return robot;
      }
    }
    return null;
  }

  /** A field of the first entry of a class; null if there is none, or it is no text. */
  private @Nullable String text(Object @Nullable [] entries, Class<?> of, int at) {
    if (entries != null) {
      for (Object each : entries) {
        @Nullable Class<?> type = each == null ? null : type(each);
        if (each != null && type != null && of.isAssignableFrom(type)) {
          @Nullable Object[] values = values(each);
          return at < values.length && values[at] instanceof String text ? text : null;
        }
      }
    }
    return null;
  }

  private @Nullable Object[] values(Object entry) {
    @Nullable Object values = ReggieFields.value(fields, entry);
    return values instanceof Object[] array ? array : new Object[0];
  }

  /**
   * The class of an entry, if it is known here and equals the client's. The superclasses that a
   * client sends prove nothing: reggie finds an entry by them, whatever the name of its class.
   */
  @Nullable Class<?> type(Object entry) {
    @Nullable Object described = ReggieFields.value(entryClass, entry);
    @Nullable String name = described == null ? null : descriptors.name(described);
    if (described == null || name == null) {
      return null;
    }
    try {
      Class<?> type = ClassLookup.find(name, RobotClaimReader.class.getClassLoader());
      return descriptors.describes(described, type) ? type : null;
    } catch (ClassNotFoundException | LinkageError e) { // of an unknown registrant
      return null;
    }
  }
}
