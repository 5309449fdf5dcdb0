package org.dfra.app.module;

import java.rmi.Remote;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/** What kinds of module a proxy is: the interfaces that it offers its clients. */
public final class ModuleKinds {

  private ModuleKinds() {}

  /**
   * The most special kinds, such as {@code GPSSensor}, not those above them.
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

  /** Every interface that is for clients, whether of modules or of what a module also is. */
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
