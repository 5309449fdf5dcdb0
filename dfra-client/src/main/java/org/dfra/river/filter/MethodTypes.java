package org.dfra.river.filter;

import java.io.Externalizable;
import java.io.ObjectOutputStream;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * The types that the arguments of one remote method may contain.
 *
 * <p>If the declarations of a method's parameters determine all types that they can contain, only
 * those are read: primitive values, values of the JDK, enums, records and final classes with the
 * types of their fields, all permitted subclasses of a sealed type, arrays and collections of
 * these. Any other type may have subclasses that are unknown here. A method with such a parameter,
 * or with such a field in one, accepts all types in {@link AllowedTypes}.
 */
final class MethodTypes {

  private static final Set<String> VALUE_PACKAGES = Set.of("java.math", "java.time");

  private static final Set<Class<?>> VALUES =
      Set.of(
          Boolean.class,
          Byte.class,
          Character.class,
          Double.class,
          Float.class,
          Integer.class,
          Long.class,
          Short.class,
          Number.class,
          Enum.class,
          String.class,
          java.net.URI.class,
          java.util.UUID.class);

  private final String method;
  private final AllowedTypes types;
  private final Closure closure = new Closure();

  private MethodTypes(Method method, AllowedTypes types) {
    this.method = method.getDeclaringClass().getSimpleName() + "." + method.getName();
    this.types = types;
    Arrays.stream(method.getGenericParameterTypes()).forEach(closure::add);
  }

  /**
   * Derives the types from the method's declaration.
   *
   * @param configured the types that may be read at all; the packages of the parameters are added
   */
  static MethodTypes of(Method method, AllowedTypes configured) {
    return new MethodTypes(method, configured.with(Arrays.asList(method.getParameterTypes())));
  }

  /** Whether its parameters may contain classes that its declaration does not determine. */
  boolean acceptsUndeclaredTypes() {
    return closure.open;
  }

  /**
   * Checks one class.
   *
   * @throws RefusedDataException if no argument of the method may contain it
   */
  void check(Class<?> type) {
    types.check(type);
    Class<?> element = AllowedTypes.element(type);
    if (!closure.open
        && !element.isPrimitive()
        && !isValue(element)
        && !closure.named.contains(element)
        && !(closure.collections && isCollection(element))) {
      throw new RefusedDataException(
          "refused to read class "
              + element.getName()
              + ": no argument of "
              + method
              + " holds one; call it as its interface declares it");
    }
  }

  @Override
  public String toString() {
    return method;
  }

  private static boolean isValue(Class<?> type) {
    return VALUES.contains(type)
        || (type.getClassLoader() == null && VALUE_PACKAGES.contains(type.getPackageName()));
  }

  /** The JDK's own collections, including their serial proxies. */
  private static boolean isCollection(Class<?> type) {
    return type == Object.class
        || (type.getClassLoader() == null && type.getPackageName().equals("java.util"));
  }

  /** All types that are reachable from declared ones. */
  private static final class Closure {

    private final Set<Class<?>> named = new HashSet<>();
    private boolean open;
    private boolean collections;

    void add(Type type) {
      if (type instanceof Class<?> plain) {
        add(plain);
      } else if (type instanceof GenericArrayType array) {
        add(array.getGenericComponentType());
      } else if (type instanceof ParameterizedType generic
          && generic.getRawType() instanceof Class<?> raw
          && isCollection(raw)
          && (Collection.class.isAssignableFrom(raw) || Map.class.isAssignableFrom(raw))) {
        collections = true;
        Arrays.stream(generic.getActualTypeArguments()).forEach(this::add);
      } else if (type instanceof WildcardType wildcard) {
        Arrays.stream(wildcard.getUpperBounds()).forEach(this::add);
      } else { // a type variable, another generic class
        open = true;
      }
    }

    private void add(Class<?> declared) {
      Class<?> type = AllowedTypes.element(declared);
      if (type.isPrimitive() || isValue(type) || !named.add(type)) {
        return;
      }
      if (type.isSealed()) {
        Arrays.stream(type.getPermittedSubclasses()).forEach(this::add);
      } else if (!type.isEnum() && !Modifier.isFinal(type.getModifiers())) {
        open = true;
      }
      if (!type.isInterface() && !type.isEnum()) {
        addFields(type);
      }
    }

    private void addFields(Class<?> type) {
      if (type.getClassLoader() == null || writesItself(type)) {
        open = true; // its serial form does not follow from its fields
        return;
      }
      for (Field field : type.getDeclaredFields()) {
        int modifiers = field.getModifiers();
        if (!Modifier.isStatic(modifiers) && !Modifier.isTransient(modifiers)) {
          add(field.getGenericType());
        }
      }
      Class<?> parent = type.getSuperclass();
      if (parent != null && parent != Object.class && parent != Record.class && named.add(parent)) {
        addFields(parent);
      }
    }

    private static boolean writesItself(Class<?> type) {
      return Externalizable.class.isAssignableFrom(type)
          || declares(type, "writeReplace")
          || declares(type, "writeObject", ObjectOutputStream.class)
          || Arrays.stream(type.getDeclaredFields())
              .anyMatch(field -> field.getName().equals("serialPersistentFields"));
    }

    private static boolean declares(Class<?> type, String method, Class<?>... parameters) {
      return Arrays.stream(type.getDeclaredMethods())
          .anyMatch(
              declared ->
                  declared.getName().equals(method)
                      && Arrays.equals(declared.getParameterTypes(), parameters));
    }
  }
}
