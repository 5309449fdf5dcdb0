package org.dfra.river.access;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.module.Administrative;
import org.jspecify.annotations.Nullable;

/**
 * Finds the administrative methods of a remote object: those that one of its interfaces marks with
 * {@link Administrative}, and those of River's own administration interfaces that change a service.
 * The latter have no annotation; their read-only methods begin with {@code get}.
 */
final class AdministrativeMethods {

  /** By name: a client that downloads this class may not have them. */
  private static final Set<String> RIVER =
      Set.of(
          "com.sun.jini.admin.DestroyAdmin",
          "com.sun.jini.admin.StorageLocationAdmin",
          "net.jini.admin.JoinAdmin",
          "net.jini.lookup.DiscoveryAdmin");

  private AdministrativeMethods() {}

  /**
   * Selects the administrative ones of some methods.
   *
   * @param methods remote methods of an object
   * @param type the object's class
   */
  static Set<Method> among(Collection<Method> methods, Class<?> type) {
    List<Method> marked =
        interfaces(type).stream()
            .flatMap(each -> Arrays.stream(each.getDeclaredMethods()))
            .filter(AdministrativeMethods::isMarked)
            .toList();
    return methods.stream()
        .filter(method -> marked.stream().anyMatch(each -> isSame(each, method)))
        .collect(Collectors.toUnmodifiableSet());
  }

  /** All interfaces that a class implements, in the order of their declaration. */
  static Set<Class<?>> interfaces(Class<?> type) {
    Set<Class<?>> interfaces = new LinkedHashSet<>();
    collect(type, interfaces);
    return interfaces;
  }

  private static void collect(@Nullable Class<?> type, Set<Class<?>> interfaces) {
    if (type == null) {
      return;
    }
    if (type.isInterface() && !interfaces.add(type)) {
      return;
    }
    collect(type.getSuperclass(), interfaces);
    for (Class<?> each : type.getInterfaces()) {
      collect(each, interfaces);
    }
  }

  /**
   * Compares name and parameters, since the dispatcher may take the method from any of several
   * interfaces.
   */
  private static boolean isSame(Method one, Method other) {
    return one.getName().equals(other.getName())
        && Arrays.equals(one.getParameterTypes(), other.getParameterTypes());
  }

  private static boolean isMarked(Method method) {
    return method.isAnnotationPresent(Administrative.class)
        || (RIVER.contains(method.getDeclaringClass().getName())
            && !method.getName().startsWith("get"));
  }
}
