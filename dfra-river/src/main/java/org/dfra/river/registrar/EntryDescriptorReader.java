package org.dfra.river.registrar;

import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import net.jini.lookup.entry.Address;
import net.jini.lookup.entry.Comment;
import net.jini.lookup.entry.Location;
import net.jini.lookup.entry.Name;
import net.jini.lookup.entry.ServiceInfo;
import org.dfra.river.entry.Entries;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Reads reggie's descriptors of entry classes: name, hash, number of fields, and the superclass's
 * descriptor. Clients create them. Reggie treats two classes with one hash as the same, whatever
 * else their descriptors contain. So a forged descriptor must not share the hash of a true one.
 */
final class EntryDescriptorReader {

  /** The limit of superclasses of one class. */
  private static final int MOST_LEVELS = 64;

  private final Field name;
  private final Field hash;
  private final Field superclass;
  private final Field fieldCount;
  private final Method describing;
  private final Field described;

  /** Descriptors of DFRA's entries, of River's usual ones, and of their superclasses, by hash. */
  private final Map<Long, Object> known = new HashMap<>();

  /**
   * @param loader of reggie's classes
   * @throws ReflectiveOperationException if that is not reggie 2.2.2
   */
  EntryDescriptorReader(@Nullable ClassLoader loader) throws ReflectiveOperationException {
    Class<?> type = Class.forName("com.sun.jini.reggie.EntryClass", false, loader);
    name = ReggieFields.accessible(type, "name");
    hash = ReggieFields.accessible(type, "hash");
    superclass = ReggieFields.accessible(type, "superclass");
    fieldCount = ReggieFields.accessible(type, "numFields");
    describing =
        Class.forName("com.sun.jini.reggie.ClassMapper", false, loader)
            .getDeclaredMethod("toEntryClassBase", Class.class);
    describing.setAccessible(true);
    described =
        ReggieFields.accessible(
            Class.forName("com.sun.jini.reggie.EntryClassBase", false, loader), "eclass");
    List<Class<?>> classes = Entries.entryClasses();
    classes.addAll(
        List.of(Address.class, Comment.class, Location.class, Name.class, ServiceInfo.class));
    for (Class<?> each : classes) {
      @Nullable Object descriptor = own(each);
      while (descriptor != null) {
        known.put(hash(descriptor), descriptor);
        descriptor = parent(descriptor);
      }
    }
  }

  /** The descriptor that a client with the same class sends; null if it is no class of entries. */
  private @Nullable Object own(Class<?> type) {
    try {
      return described.get(describing.invoke(null, type));
    } catch (InvocationTargetException e) {
      return null; // it is not public, or has a field that no entry has
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** The name of the class; null if the descriptor has none. */
  @Nullable String name(Object descriptor) {
    return (String) ReggieFields.value(name, descriptor);
  }

  private long hash(Object descriptor) {
    return ReggieFields.number(hash, descriptor);
  }

  /** The number of fields of an entry of the class, with those of its superclasses. */
  int fieldCount(Object descriptor) {
    return (int) ReggieFields.number(fieldCount, descriptor);
  }

  /** The descriptor of the superclass; null for that of {@link Object}. */
  @Nullable Object parent(Object descriptor) {
    return ReggieFields.value(superclass, descriptor);
  }

  /** Whether a descriptor equals that of the local class, with its superclasses. */
  boolean describes(Object descriptor, Class<?> type) {
    @Nullable Object own = own(type);
    return own != null && same(descriptor, own);
  }

  /** Whether two descriptors are equal, with their superclasses. */
  boolean same(Object one, Object other) {
    @Nullable Object left = one;
    @Nullable Object right = other;
    for (int level = 0; left != null && right != null && level < MOST_LEVELS; level++) {
      if (hash(left) != hash(right)
          || fieldCount(left) != fieldCount(right)
          || !String.valueOf(name(left)).equals(name(right))) {
        return false;
      }
      left = parent(left);
      right = parent(right);
    }
    return left == null && right == null;
  }

  /**
   * Checks what reggie relies on: the chain of superclasses ends, the last one has no fields, and
   * none has more than its subclass.
   *
   * @throws IllegalArgumentException if a check fails
   */
  void check(Object descriptor) {
    Object each = descriptor;
    for (int level = 0; level < MOST_LEVELS; level++) {
      @Nullable Object parent = parent(each);
      int inherited = parent == null ? 0 : fieldCount(parent);
      boolean isLast = parent == null;
      if (inherited < 0
          || fieldCount(each) < inherited
          || (isLast && fieldCount(each) > inherited)) {
        throw new IllegalArgumentException(
            "entry class "
                + inWords(each)
                + " has "
                + fieldCount(each)
                + " fields and inherits "
                + inherited
                + "; send what River's own client does");
      }
      if (parent == null) {
        return;
      }
      each = parent;
    }
    throw new IllegalArgumentException(
        "entry class "
            + inWords(descriptor)
            + " has more than "
            + MOST_LEVELS
            + " superclasses; register entries of another class");
  }

  /**
   * Checks that a class does not have the hash of a different one.
   *
   * @param descriptor one that was checked
   * @throws IllegalArgumentException if it has the hash of a class that is known here, and differs
   */
  void checkKnown(Object descriptor) {
    for (@Nullable Object each = descriptor; each != null; each = parent(each)) {
      @Nullable Object own = known.get(hash(each));
      if (own != null && !same(each, own)) {
        throw differs(each, own);
      }
    }
  }

  /** The refusal of a descriptor that has the hash of a different one. */
  IllegalArgumentException differs(Object descriptor, Object from) {
    return new IllegalArgumentException(
        "entry class "
            + inWords(descriptor)
            + " has the hash of "
            + inWords(from)
            + ", and differs from it; send what River's own client does");
  }

  private String inWords(Object descriptor) {
    return PrintableText.word(String.valueOf(name(descriptor)));
  }
}
