package org.dfra.river.registrar;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dfra.river.entry.Mirrors;
import org.dfra.river.entry.RecordEntry;
import org.dfra.security.Visibility;
import org.dfra.security.Visibility.ListedService;
import org.dfra.security.Visibility.OfService;
import org.jspecify.annotations.Nullable;

/**
 * Reggie's items as a caller sees them. A field that is hidden is null, like one that the service
 * does not know. An entry of which everything is hidden is missing, and one of which only the parts
 * of its superclass are seen is of that class. So a template that names what is hidden matches as
 * if it did not exist.
 *
 * <p>The names of fields are known for classes that this process has. An entry of another class is
 * seen entirely or not at all, and so is a {@link RecordEntry}, whose values are marshalled as one.
 * No entry is unmarshalled. Thread-safe.
 */
final class VisibleItems {

  /**
   * The fields that one class of an entry declares.
   *
   * @param type full name of the record that the class mirrors, or of the class itself
   * @param components their names, in reggie's order
   */
  private record DeclaredFields(String type, List<String> components) {}

  private static final ClassValue<DeclaredFields> DECLARED =
      new ClassValue<>() {
        @Override
        protected DeclaredFields computeValue(Class<?> type) {
          @Nullable Mirrors mirrors = type.getDeclaredAnnotation(Mirrors.class);
          return new DeclaredFields(
              mirrors == null ? type.getName() : mirrors.value().getName(), fieldNames(type));
        }
      };

  private static final int RECORD_TYPE = fieldNames(RecordEntry.class).indexOf("type");

  private final ReggieItems items;
  private final RobotClaimReader claims;
  private final EntryDescriptorReader descriptors;
  private final Field typeName;
  private final Field supertype;
  private final Field interfaces;

  /**
   * @param loader of reggie's classes
   * @throws ReflectiveOperationException if that is not reggie 2.2.2
   */
  VisibleItems(
      @Nullable ClassLoader loader,
      ReggieItems items,
      RobotClaimReader claims,
      EntryDescriptorReader descriptors)
      throws ReflectiveOperationException {
    this.items = items;
    this.claims = claims;
    this.descriptors = descriptors;
    Class<?> type = Class.forName("com.sun.jini.reggie.ServiceType", false, loader);
    typeName = ReggieFields.accessible(type, "name");
    supertype = ReggieFields.accessible(type, "superclass");
    interfaces = ReggieFields.accessible(type, "interfaces");
  }

  private static List<String> fieldNames(Class<?> type) {
    int not = Modifier.STATIC | Modifier.TRANSIENT | Modifier.FINAL;
    return Arrays.stream(type.getDeclaredFields())
        .filter(each -> Modifier.isPublic(each.getModifiers()))
        .filter(each -> (each.getModifiers() & not) == 0)
        .map(Field::getName)
        .sorted()
        .toList();
  }

  /**
   * An item as a caller sees it. The given one is not changed.
   *
   * @return null if the caller does not see the service; the item itself if it sees everything
   */
  @Nullable Object seen(Object item, Visibility visibility) {
    if (visibility.isComplete()) {
      return item;
    }
    Object[] all = items.entries(item);
    OfService service = visibility.of(listed(item, all));
    if (!service.isShown()) {
      return null;
    }
    List<Object> seen = new ArrayList<>(all.length);
    boolean isSame = true;
    for (Object each : all) {
      @Nullable Object shown = entry(each, service);
      isSame &= shown == each;
      if (shown != null) {
        seen.add(shown);
      }
    }
    return isSame ? item : items.copy(item, seen);
  }

  private ListedService listed(Object item, Object[] entries) {
    Set<String> types = new HashSet<>();
    addTypes(items.serviceType(item), types);
    return new ListedService(
        Objects.requireNonNullElse(claims.robot(entries), ""),
        Objects.requireNonNullElse(claims.name(entries), ""),
        types);
  }

  private void addTypes(Object type, Set<String> names) {
    if (!names.add((String) ReggieFields.present(typeName, type))) {
      return;
    }
    if (ReggieFields.value(interfaces, type) instanceof Object[] all) {
      for (Object each : all) {
        addTypes(each, names);
      }
    }
    @Nullable Object parent = ReggieFields.value(supertype, type);
    if (parent != null) {
      addTypes(parent, names);
    }
  }

  /** An entry as it is seen; null if not at all. */
  private @Nullable Object entry(Object entry, OfService service) {
    @Nullable Object[] fields = items.fields(entry);
    Object described = items.entryClass(entry);
    @Nullable Class<?> type = claims.type(entry);
    if (type == null) {
      return service.isShown(Objects.requireNonNullElse(descriptors.name(described), ""))
          ? entry
          : null;
    }
    if (type == RecordEntry.class) {
      String record = fields[RECORD_TYPE] instanceof String name ? name : type.getName();
      return service.isShown(record) ? entry : null;
    }
    return known(entry, described, type, fields, service);
  }

  private @Nullable Object known(
      Object entry, Object described, Class<?> type, @Nullable Object[] fields, OfService service) {
    @Nullable Object[] seen = fields.clone();
    @Nullable Object descriptor = described;
    @Nullable Class<?> declaring = type;
    @Nullable Object seenClass = null; // the most specific one of which something is seen
    while (descriptor != null && declaring != null) {
      @Nullable Object parent = descriptors.parent(descriptor);
      int inherited = parent == null ? 0 : descriptors.fieldCount(parent);
      int end = descriptors.fieldCount(descriptor);
      if (hide(seen, inherited, end, DECLARED.get(declaring), service) && seenClass == null) {
        seenClass = descriptor;
      }
      descriptor = parent;
      declaring = declaring.getSuperclass();
    }
    if (seenClass == null) {
      return null;
    }
    boolean isSame = seenClass == described && Arrays.equals(seen, fields);
    return isSame
        ? entry
        : items.copy(entry, seenClass, Arrays.copyOf(seen, descriptors.fieldCount(seenClass)));
  }

  /** Hides fields of one class; returns whether something of the class is seen. */
  private static boolean hide(
      @Nullable Object[] fields, int from, int to, DeclaredFields declared, OfService service) {
    if (declared.components().size() != to - from) { // a class that is not what it seems
      Arrays.fill(fields, from, to, null);
      return false;
    }
    if (from == to) {
      return from > 0 && service.isShown(declared.type());
    }
    boolean isAnySeen = false;
    for (int i = from; i < to; i++) {
      if (service.isShown(declared.type(), declared.components().get(i - from))) {
        isAnySeen = true;
      } else {
        fields[i] = null;
      }
    }
    return isAnySeen;
  }
}
