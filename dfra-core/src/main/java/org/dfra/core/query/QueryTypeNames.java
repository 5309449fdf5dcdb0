package org.dfra.core.query;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.config.NearestName;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.PersonaAttributes;

/**
 * The kinds of modules and of attributes that a query may name. Immutable.
 *
 * <p>A kind is named by its interface, {@code GPSSensor}; an attribute record by its class, with or
 * without {@code Attributes}: {@code SensorAttributes}, {@code Sensor}, {@code sensor}, {@code
 * gps_receiver}. If nothing matches exactly, case and underscores are ignored. The full name of a
 * class is always valid.
 */
public final class QueryTypeNames {

  private static final String SUFFIX = "Attributes";

  private static final QueryTypeNames STANDARD =
      new QueryTypeNames(Set.of(), Set.of())
          .with(
              TypeFinder.besides(Module.class).stream()
                  .filter(type -> type != PersonaAttributes.class) // of a robot, not of a module
                  .toList());

  private final Set<Class<? extends Module>> kinds;
  private final Set<Class<? extends Attributes>> attributes;

  private QueryTypeNames(
      Set<Class<? extends Module>> kinds, Set<Class<? extends Attributes>> attributes) {
    this.kinds = kinds;
    this.attributes = attributes;
  }

  /** The vocabulary of dfra-api: all its module interfaces and attribute records. */
  public static QueryTypeNames standard() {
    return STANDARD;
  }

  /**
   * A copy with the module interfaces and attribute records among these types. Other types are
   * ignored.
   */
  public QueryTypeNames with(Collection<? extends Class<?>> types) {
    Set<Class<? extends Module>> moreKinds = new LinkedHashSet<>(kinds);
    Set<Class<? extends Attributes>> moreAttributes = new LinkedHashSet<>(attributes);
    for (Class<?> type : types) {
      if (type.isInterface() && Module.class.isAssignableFrom(type)) {
        moreKinds.add(type.asSubclass(Module.class));
      } else if (type.isRecord() && Attributes.class.isAssignableFrom(type)) {
        moreAttributes.add(type.asSubclass(Attributes.class));
      }
    }
    return new QueryTypeNames(moreKinds, moreAttributes);
  }

  /** The kinds of modules. */
  public Set<Class<? extends Module>> kinds() {
    return Set.copyOf(kinds);
  }

  /** The kinds of attributes. */
  public Set<Class<? extends Attributes>> attributes() {
    return Set.copyOf(attributes);
  }

  /** The kind of module of that name. */
  Class<? extends Module> kind(Token name) {
    return named(name, name.text(), kinds, "there is no kind of module \"" + name.text() + "\"");
  }

  /** The kind of attributes of that name, which is the beginning of the token. */
  Class<? extends Attributes> attributes(Token at, String name) {
    return named(at, name, attributes, "there are no attributes \"" + name + "\"");
  }

  /** The component of that name. */
  static RecordComponent component(Token at, Class<? extends Attributes> type, String name) {
    RecordComponent[] all = type.getRecordComponents();
    for (RecordComponent each : all) {
      if (each.getName().equals(name)) {
        return each;
      }
    }
    for (RecordComponent each : all) {
      if (plain(each.getName()).equals(plain(name))) {
        return each;
      }
    }
    List<String> names = Arrays.stream(all).map(RecordComponent::getName).toList();
    throw new QuerySyntaxException(
        at,
        type.getSimpleName()
            + " has no component \""
            + name
            + "\""
            + NearestName.hint(name, names, "; it has " + String.join(", ", names)));
  }

  private static <T> Class<? extends T> named(
      Token at, String name, Set<Class<? extends T>> all, String unknown) {
    List<Class<? extends T>> exact =
        all.stream()
            .filter(type -> type.getSimpleName().equals(name) || type.getName().equals(name))
            .toList();
    List<Class<? extends T>> found =
        exact.isEmpty()
            ? all.stream()
                .filter(type -> plain(shortName(type)).equals(plain(withoutSuffix(name))))
                .toList()
            : exact;
    if (found.isEmpty()) {
      List<String> names = all.stream().map(QueryTypeNames::shortName).sorted().toList();
      throw new QuerySyntaxException(
          at,
          unknown
              + NearestName.hint(
                  withoutSuffix(name), names, "; there is " + String.join(", ", names)));
    }
    if (found.size() > 1) {
      throw new QuerySyntaxException(
          at,
          "\""
              + name
              + "\" may mean several; write "
              + found.stream().map(Class::getName).sorted().collect(Collectors.joining(" or ")));
    }
    return found.get(0);
  }

  private static String shortName(Class<?> type) {
    return withoutSuffix(type.getSimpleName());
  }

  private static String withoutSuffix(String name) {
    return name.endsWith(SUFFIX) && name.length() > SUFFIX.length()
        ? name.substring(0, name.length() - SUFFIX.length())
        : name;
  }

  private static String plain(String name) {
    return name.replace("_", "").toLowerCase(Locale.ROOT);
  }
}
