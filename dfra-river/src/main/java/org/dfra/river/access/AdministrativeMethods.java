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
 * Which methods of a remote object are administrative: those that one of its interfaces marks with
 * {@link Administrative}, and those by which River's own interfaces for administrators change a
 * service. The latter carry no mark; their questions begin with {@code get}.
 */
final class AdministrativeMethods {

  /** By name: a client that downloads this class need not have them. */
  private static final Set<String> RIVER =
      Set.of(
          "com.sun.jini.admin.DestroyAdmin",
          "com.sun.jini.admin.StorageLocationAdmin",
          "net.jini.admin.JoinAdmin",
          "net.jini.lookup.DiscoveryAdmin");

  private AdministrativeMethods() {}

  /**
   * Those among some methods.
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

  /** Whichever of several interfaces the dispatcher took the method from. */
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
