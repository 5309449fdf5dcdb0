package org.dfra.river.registrar;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import net.jini.core.lookup.ServiceID;
import org.dfra.text.PrintableText;
import org.jspecify.annotations.Nullable;

/**
 * Checks that the arguments of a call are valid: as River's own client sends them.
 *
 * <p>Reggie relies on that. A null type or entry in an array ends the thread that removes expired
 * registrations, or fails every later registration. A superclass that is its own superclass makes
 * reggie hold its lock forever. A field's value becomes a key of reggie's tables, a list of leases
 * costs the square of its length, and two classes of one hash share tables of one width. One call
 * of a few hundred bytes would disable the lookup service for all clients.
 *
 * <p>Thread-safe.
 */
final class ReggieArgumentValidator {

  /** The limit of entries of one service or of one template. */
  static final int MAX_ENTRIES = 256;

  /** The limit of types in one template. */
  static final int MAX_TYPES = 64;

  /** The limit of supertypes of one type, each counted as often as it is inherited. */
  static final int MAX_SUPERTYPES = 2048;

  /** The limit of leases that one call renews or cancels. */
  static final int MAX_LEASES = 4096;

  private static final String OBJECT = "java.lang.Object";

  private static final Set<Class<?>> VALUES =
      Set.of(
          String.class,
          Integer.class,
          Boolean.class,
          Character.class,
          Long.class,
          Float.class,
          Double.class,
          Byte.class,
          Short.class);

  private final ReggieState state;
  private final EntryDescriptorReader descriptors;
  private final Class<?> marshalled;
  private final Class<?> entryType;
  private final Field entryClass;
  private final Field entryFields;
  private final Field itemType;
  private final Field itemEntries;
  private final Field templateTypes;
  private final Field templateEntries;
  private final Field typeName;
  private final Field parentType;
  private final Field interfaces;

  /**
   * @param loader of reggie's classes
   * @throws ReflectiveOperationException if that is not reggie 2.2.2
   */
  ReggieArgumentValidator(
      @Nullable ClassLoader loader, ReggieState state, EntryDescriptorReader descriptors)
      throws ReflectiveOperationException {
    this.state = state;
    this.descriptors = descriptors;
    marshalled = Class.forName("com.sun.jini.proxy.MarshalledWrapper", false, loader);
    entryType = Class.forName("com.sun.jini.reggie.EntryRep", false, loader);
    entryClass = ReggieFields.accessible(entryType, "eclass");
    entryFields = ReggieFields.accessible(entryType, "fields");
    Class<?> item = Class.forName("com.sun.jini.reggie.Item", false, loader);
    itemType = ReggieFields.accessible(item, "serviceType");
    itemEntries = ReggieFields.accessible(item, "attributeSets");
    Class<?> template = Class.forName("com.sun.jini.reggie.Template", false, loader);
    templateTypes = ReggieFields.accessible(template, "serviceTypes");
    templateEntries = ReggieFields.accessible(template, "attributeSetTemplates");
    Class<?> type = Class.forName("com.sun.jini.reggie.ServiceType", false, loader);
    typeName = ReggieFields.accessible(type, "name");
    parentType = ReggieFields.accessible(type, "superclass");
    interfaces = ReggieFields.accessible(type, "interfaces");
  }

  /**
   * Checks the arguments of a call to reggie.
   *
   * @param method its name
   * @throws IllegalArgumentException if River's own client does not send such arguments
   */
  void check(String method, @Nullable Object[] args) {
    switch (method) {
      case "register" -> item(args[0]);
      case "lookup", "notify", "getEntryClasses", "getFieldValues", "getServiceTypes" ->
          template(args[0]);
      case "addAttributes", "setAttributes" -> registered(args[2]);
      case "modifyAttributes" -> {
        entries(args[2], false);
        entries(args[3], true);
      }
      case "renewLeases", "cancelLeases" -> leases(args);
      default -> {
        // identifiers and numbers only
      }
    }
  }

  private void item(@Nullable Object item) {
    @Nullable Object type = ReggieFields.value(itemType, present(item, "a service item"));
    type(present(type, "a type of a service"));
    registered(ReggieFields.value(itemEntries, present(item, "a service item")));
  }

  private void template(@Nullable Object template) {
    Object given = present(template, "a template");
    @Nullable Object types = ReggieFields.value(templateTypes, given);
    if (types != null) {
      atMost(Array.getLength(types), MAX_TYPES, "types of a template");
      for (int i = 0; i < Array.getLength(types); i++) {
        type(present(Array.get(types, i), "a type of a template"));
      }
    }
    entries(ReggieFields.value(templateEntries, given), false);
  }

  /** Checks entries that reggie stores; null for none. */
  private void registered(@Nullable Object entries) {
    entries(entries, false);
    if (entries != null) {
      for (int i = 0; i < Array.getLength(entries); i++) {
        Object entry = Array.get(entries, i);
        unambiguous(present(ReggieFields.value(entryClass, entry), "an entry class"));
      }
    }
  }

  /**
   * @param mayBeNull whether null represents an entry to delete
   */
  private void entries(@Nullable Object entries, boolean mayBeNull) {
    if (entries == null) {
      return;
    }
    atMost(Array.getLength(entries), MAX_ENTRIES, "entries");
    for (int i = 0; i < Array.getLength(entries); i++) {
      @Nullable Object entry = Array.get(entries, i);
      if (entry != null || !mayBeNull) {
        entry(present(entry, "an entry"));
      }
    }
  }

  private void entry(Object entry) {
    Object described = present(ReggieFields.value(entryClass, entry), "an entry class");
    descriptors.check(described);
    Object fields = present(ReggieFields.value(entryFields, entry), "an array of fields");
    int count = descriptors.fieldCount(described);
    if (fields.getClass() != Object[].class || Array.getLength(fields) != count) {
      throw malformed("an entry has other fields than its class, which has " + count);
    }
    for (@Nullable Object each : (@Nullable Object[]) fields) {
      if (each != null && !VALUES.contains(each.getClass()) && !marshalled.isInstance(each)) {
        throw malformed(
            "a field of an entry holds " + PrintableText.word(each.getClass().getName()));
      }
    }
  }

  /** Reggie keeps one table for a class and each of its superclasses, identified by hashes. */
  private void unambiguous(Object described) {
    descriptors.checkKnown(described);
    @Nullable Object listed = state.entryClass(described);
    if (listed != null && !descriptors.same(described, listed)) {
      throw descriptors.differs(described, listed);
    }
    for (@Nullable Object each = described; each != null; each = descriptors.parent(each)) {
      int width = state.entryFieldCount(each);
      if (width >= 0 && width != descriptors.fieldCount(each)) {
        throw descriptors.differs(each, each);
      }
    }
  }

  private void type(Object type) {
    int unused = supertypes(type, new HashMap<>(), 0);
  }

  /**
   * Visits a type's supertypes as reggie does, each as often as it is inherited.
   *
   * @param visited how many were visited before
   * @return how many were visited after it
   */
  private int supertypes(Object type, Map<String, Object> byName, int visited) {
    int count = visited + 1;
    atMost(count, MAX_SUPERTYPES, "supertypes of a type");
    String name = name(type);
    @Nullable Object before = byName.putIfAbsent(name, type);
    if (before != null && before != type && !isAlike(before, type)) {
      throw malformed("there are two types " + PrintableText.word(name));
    }
    @Nullable Object inherited = ReggieFields.value(interfaces, type);
    boolean isObject = name.equals(OBJECT);
    if (isObject != state.isObjectType(type) || isObject != (inherited == null)) {
      throw malformed(
          "the type " + PrintableText.word(name) + " is neither a class nor an interface");
    }
    @Nullable Object parent = ReggieFields.value(parentType, type);
    if (inherited != null) {
      for (int i = 0; i < Array.getLength(inherited); i++) {
        Object each = present(Array.get(inherited, i), "an interface of a type");
        if (ReggieFields.value(parentType, each) != null) {
          throw malformed("the type " + PrintableText.word(name) + " implements a class");
        }
        count = supertypes(each, byName, count);
      }
    }
    return parent == null ? count : supertypes(parent, byName, count);
  }

  private String name(Object type) {
    return (String) present(ReggieFields.value(typeName, type), "a name of a type");
  }

  /** Whether two types of one name inherit from types with the same names. */
  private boolean isAlike(Object one, Object other) {
    return inherited(one).equals(inherited(other));
  }

  private String inherited(Object type) {
    StringBuilder names = new StringBuilder();
    @Nullable Object parent = ReggieFields.value(parentType, type);
    names.append(parent == null ? "" : name(parent));
    @Nullable Object all = ReggieFields.value(interfaces, type);
    for (int i = 0; all != null && i < Array.getLength(all); i++) {
      names.append('\n').append(name(present(Array.get(all, i), "an interface of a type")));
    }
    return names.toString();
  }

  /** Checks lists of leases: their registrations, their IDs and, to renew them, durations. */
  private static void leases(@Nullable Object[] args) {
    Object[] registrations = (Object[]) present(args[0], "a list of registrations");
    atMost(registrations.length, MAX_LEASES, "leases");
    for (@Nullable Object each : args) {
      if (Array.getLength(present(each, "a list of leases")) != registrations.length) {
        throw malformed("lists of leases have different lengths");
      }
    }
    for (@Nullable Object each : registrations) {
      if (!(each instanceof ServiceID || each instanceof Long)) {
        throw malformed("a lease is of neither a service nor a listener");
      }
    }
  }

  private static Object present(@Nullable Object given, String what) {
    if (given == null) {
      throw malformed(what + " is missing");
    }
    return given;
  }

  private static void atMost(int count, int most, String what) {
    if (count > most) {
      throw new IllegalArgumentException(
          "the lookup service refuses a call: " + count + " " + what + " > " + most + " allowed");
    }
  }

  private static IllegalArgumentException malformed(String what) {
    return new IllegalArgumentException(
        "the lookup service refuses a call: " + what + "; send what River's own client does");
  }
}
