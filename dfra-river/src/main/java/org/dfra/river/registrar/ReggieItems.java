package org.dfra.river.registrar;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.rmi.MarshalledObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceEvent;
import net.jini.core.lookup.ServiceID;
import org.jspecify.annotations.Nullable;

/**
 * Copies of reggie's items, and the objects of its answers. Reggie 2.2.2 has no interface for them,
 * so its fields and constructors are used. Thread-safe; what it copies is not changed.
 */
final class ReggieItems {

  private final Class<?> entryType;
  private final Method cloneItem;
  private final Method cloneEntry;
  private final Method replacedEntryClass;
  private final Method replacedServiceType;
  private final Method fromEntries;
  private final Method toEntries;
  private final Constructor<?> matches;
  private final Constructor<?> entryClassAnswer;
  private final Constructor<?> serviceTypeAnswer;
  private final Constructor<?> event;
  private final Field entryClass;
  private final Field fields;
  private final Field entryCodebase;
  private final Field entries;
  private final Field serviceType;
  private final Field codebase;
  private final Field service;
  private final Field id;
  private final Field eventItem;

  /**
   * @param loader of reggie's classes
   * @throws ReflectiveOperationException if that is not reggie 2.2.2
   */
  ReggieItems(@Nullable ClassLoader loader) throws ReflectiveOperationException {
    Class<?> item = type("Item", loader);
    Class<?> classes = type("EntryClass", loader);
    Class<?> types = type("ServiceType", loader);
    entryType = type("EntryRep", loader);
    cloneItem = ReggieFields.method(item, "clone");
    cloneEntry = ReggieFields.method(entryType, "clone");
    replacedEntryClass = ReggieFields.method(classes, "getReplacement");
    replacedServiceType = ReggieFields.method(types, "getReplacement");
    fromEntries = ReggieFields.method(entryType, "toEntryRep", Entry[].class, boolean.class);
    toEntries = ReggieFields.method(entryType, "toEntry", entryType.arrayType());
    matches = constructor("Matches", loader, ArrayList.class, int.class);
    entryClassAnswer = constructor("EntryClassBase", loader, classes, String.class);
    serviceTypeAnswer = constructor("ServiceTypeBase", loader, types, String.class);
    event =
        constructor(
            "RegistrarEvent",
            loader,
            Object.class,
            long.class,
            long.class,
            MarshalledObject.class,
            ServiceID.class,
            int.class,
            item);
    entryClass = ReggieFields.accessible(entryType, "eclass");
    fields = ReggieFields.accessible(entryType, "fields");
    entryCodebase = ReggieFields.accessible(entryType, "codebase");
    entries = ReggieFields.accessible(item, "attributeSets");
    serviceType = ReggieFields.accessible(item, "serviceType");
    codebase = ReggieFields.accessible(item, "codebase");
    service = ReggieFields.accessible(item, "service");
    id = ReggieFields.accessible(item, "serviceID");
    eventItem = ReggieFields.accessible(type("RegistrarEvent", loader), "item");
  }

  private static Class<?> type(String name, @Nullable ClassLoader loader)
      throws ClassNotFoundException {
    return Class.forName("com.sun.jini.reggie." + name, false, loader);
  }

  private static Constructor<?> constructor(
      String type, @Nullable ClassLoader loader, Class<?>... parameters)
      throws ReflectiveOperationException {
    Constructor<?> constructor = type(type, loader).getDeclaredConstructor(parameters);
    constructor.setAccessible(true);
    return constructor;
  }

  /** The entries of an item; none if it has none. */
  Object[] entries(Object item) {
    return ReggieFields.value(entries, item) instanceof Object[] all ? all : new Object[0];
  }

  /** The fields of an entry, those of its superclasses first. */
  @Nullable Object[] fields(Object entry) {
    return (@Nullable Object[]) ReggieFields.present(fields, entry);
  }

  /** The descriptor of an entry's class. */
  Object entryClass(Object entry) {
    return ReggieFields.present(entryClass, entry);
  }

  /** Where the class of an entry is loaded from; null if clients must have it. */
  @Nullable Object codebase(Object entry) {
    return ReggieFields.value(entryCodebase, entry);
  }

  /** The descriptor of an item's type. */
  Object serviceType(Object item) {
    return ReggieFields.present(serviceType, item);
  }

  /** The marshalled proxy of an item. */
  Object service(Object item) {
    return ReggieFields.present(service, item);
  }

  /** A copy of an entry with another class and other fields. */
  Object copy(Object entry, Object withClass, @Nullable Object[] withFields) {
    Object copy = copied(cloneEntry, entry);
    ReggieFields.set(entryClass, copy, withClass);
    ReggieFields.set(fields, copy, withFields);
    return copy;
  }

  /** A copy of an item with its entries. Read the original under reggie's lock. */
  Object copy(Object item) {
    return copied(cloneItem, item);
  }

  /** The identifier of an item's service. */
  ServiceID serviceId(Object item) {
    return (ServiceID) ReggieFields.present(id, item);
  }

  /** Whether clients see the same of two items of a service. */
  boolean isSame(Object one, Object other) {
    return service(one).equals(service(other)) && Arrays.equals(entries(one), entries(other));
  }

  /** The item of an event, as it is sent; null if it has none. */
  @Nullable Object sentItem(ServiceEvent of) {
    return ReggieFields.value(eventItem, of);
  }

  /** A copy of an item with other entries, which are not copied. */
  Object copy(Object item, List<Object> withEntries) {
    Object copy = copied(cloneItem, item);
    Object[] none = (Object[]) Array.newInstance(entryType, 0);
    ReggieFields.set(entries, copy, withEntries.toArray(none));
    return copy;
  }

  private static Object copied(Method clone, Object original) {
    return Objects.requireNonNull(ReggieFields.call(clone, original));
  }

  /** A copy of an item as it is sent to clients: with short descriptors, and without its type. */
  Object sent(Object item) {
    Object copy = copied(cloneItem, item);
    ReggieFields.set(serviceType, copy, null);
    ReggieFields.set(codebase, copy, null);
    for (Object each : entries(copy)) {
      ReggieFields.set(entryClass, each, ReggieFields.call(replacedEntryClass, entryClass(each)));
    }
    return copy;
  }

  /** The answer of a lookup. */
  Object matches(List<Object> sent, int total) {
    return ReggieFields.made(matches, new ArrayList<>(sent), total);
  }

  /** The answer with classes of entries; null for none, as River specifies. */
  @Nullable Object entryClasses(List<Object> classes, List<@Nullable Object> codebases) {
    return array(entryClassAnswer, replacedEntryClass, classes, codebases);
  }

  /** The answer with types of services; null for none, as River specifies. */
  @Nullable Object serviceTypes(List<Object> types, List<@Nullable Object> codebases) {
    return array(serviceTypeAnswer, replacedServiceType, types, codebases);
  }

  private static @Nullable Object array(
      Constructor<?> constructor,
      Method replaced,
      List<Object> described,
      List<@Nullable Object> codebases) {
    if (described.isEmpty()) {
      return null;
    }
    Object answer = Array.newInstance(constructor.getDeclaringClass(), described.size());
    for (int i = 0; i < described.size(); i++) {
      @Nullable Object small = ReggieFields.call(replaced, described.get(i));
      Array.set(answer, i, ReggieFields.made(constructor, small, codebases.get(i)));
    }
    return answer;
  }

  /**
   * An event like another one.
   *
   * @param sent the item; null if the service is not listed any more
   */
  ServiceEvent event(ServiceEvent like, long sequence, int transition, @Nullable Object sent) {
    return (ServiceEvent)
        ReggieFields.made(
            event,
            like.getSource(),
            like.getID(),
            sequence,
            like.getRegistrationObject(),
            like.getServiceID(),
            transition,
            sent);
  }

  /** Entries in reggie's form. */
  Object[] marshalled(Entry[] all) {
    Object answer = ReggieFields.call(fromEntries, null, all, false);
    return answer instanceof Object[] made ? made : new Object[0];
  }

  /** The opposite of {@link #marshalled}. */
  Entry[] unmarshalled(List<Object> all) {
    Object[] none = (Object[]) Array.newInstance(entryType, 0);
    Object answer = ReggieFields.call(toEntries, null, (Object) all.toArray(none));
    return answer instanceof Entry[] made ? made : new Entry[0];
  }
}
