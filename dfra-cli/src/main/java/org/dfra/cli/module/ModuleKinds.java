package org.dfra.cli.module;

import java.rmi.Remote;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/** The kinds of a module: the client interfaces that its proxy implements. */
public final class ModuleKinds {

  private ModuleKinds() {}

  /**
   * The most specific kinds, such as {@code GPSSensor}, without their superinterfaces.
   *
   * @return names without their package, in alphabetical order
   */
  public static List<String> names(Module module) {
    Set<Class<?>> all = interfaces(module);
    return all.stream()
        .filter(Module.class::isAssignableFrom)
        .filter(
            kind -> all.stream().noneMatch(other -> other != kind && kind.isAssignableFrom(other)))
        .map(Class::getSimpleName)
        .sorted()
        .toList();
  }

  /**
   * Whether a module is of a kind.
   *
   * @param kind name of an interface, with or without its package
   */
  static boolean hasKind(Module module, String kind) {
    return interfaces(module).stream()
        .anyMatch(each -> each.getSimpleName().equals(kind) || each.getName().equals(kind));
  }

  /** Every client interface of the proxy, including those that are not modules. */
  public static Set<Class<?>> interfaces(Module module) {
    Set<Class<?>> found = new LinkedHashSet<>();
    for (Class<?> type = module.getClass(); type != null; type = above(type)) {
      Arrays.stream(type.getInterfaces()).forEach(each -> collect(each, found));
    }
    return found;
  }

  private static @Nullable Class<?> above(Class<?> type) {
    return type.getSuperclass();
  }

  private static void collect(Class<?> type, Set<Class<?>> found) {
    boolean isForClients =
        !Remote.class.isAssignableFrom(type)
            && !type.getName().startsWith("java.")
            && !type.getName().startsWith("net.jini.");
    if (isForClients && found.add(type)) {
      Arrays.stream(type.getInterfaces()).forEach(each -> collect(each, found));
    }
  }
}
