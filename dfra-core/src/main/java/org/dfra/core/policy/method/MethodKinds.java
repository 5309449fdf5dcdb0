package org.dfra.core.policy.method;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.InterfaceCatalogue.DeclaredKind;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Finds the kind of a remote method. For the interfaces of DFRA and River, {@link
 * InterfaceCatalogue#builtIn} says it. For those of your own, the annotations of the method do.
 */
public final class MethodKinds {

  private MethodKinds() {}

  /**
   * The kind of a method, and why.
   *
   * @param reason in a few words
   * @param isDeclared whether a table or an annotation says so; otherwise it is the kind of methods
   *     about which nothing is said: a command
   */
  public record Classification(MethodKind kind, String reason, boolean isDeclared) {}

  /**
   * Finds the kind of a method.
   *
   * @param type the called object's class, or one of its interfaces. All its interfaces that
   *     declare the method count, since a dispatcher may take the method from any of them
   */
  public static Classification of(Class<?> type, Method method) {
    @Nullable Classification found = null;
    for (Class<?> each : interfaces(type)) {
      @Nullable Method declared = declared(each, method);
      if (declared != null) {
        Optional<CataloguedInterface> known = InterfaceCatalogue.builtIn().find(each.getName());
        found = later(found, known.isPresent() ? listed(known.get(), method) : annotated(declared));
      }
    }
    return found != null
        ? found
        : new Classification(MethodKind.COMMAND, "nothing says what it does", false);
  }

  private static @Nullable Classification listed(CataloguedInterface known, Method method) {
    @Nullable DeclaredKind entry = known.declared().get(method.getName());
    return entry == null ? null : new Classification(entry.kind(), entry.reason(), true);
  }

  /** What the annotations of a method of your own say; null if nothing. */
  private static @Nullable Classification annotated(Method method) {
    if (method.isAnnotationPresent(Administrative.class)) {
      return new Classification(MethodKind.ADMINISTER, "marked @Administrative", true);
    }
    if (!method.isAnnotationPresent(Idempotent.class)) {
      return null;
    }
    // A method without a result cannot be a query, whatever happens if it is repeated.
    return method.getReturnType() == void.class
        ? new Classification(MethodKind.COMMAND, "marked @Idempotent, without a result", true)
        : new Classification(MethodKind.READ, "marked @Idempotent, with a result", true);
  }

  private static @Nullable Classification later(
      @Nullable Classification one, @Nullable Classification other) {
    if (one == null || other == null) {
      return one == null ? other : one;
    }
    return other.kind().compareTo(one.kind()) > 0 ? other : one;
  }

  private static @Nullable Method declared(Class<?> type, Method method) {
    return Arrays.stream(type.getDeclaredMethods())
        .filter(each -> isSame(each, method))
        .findFirst()
        .orElse(null);
  }

  /** Compares name and parameters. */
  static boolean isSame(Method one, Method other) {
    return one.getName().equals(other.getName())
        && Arrays.equals(one.getParameterTypes(), other.getParameterTypes());
  }

  /** All interfaces of a class, also the indirect ones; an interface itself is the first. */
  public static Set<Class<?>> interfaces(Class<?> type) {
    Set<Class<?>> interfaces = new LinkedHashSet<>();
    collect(type, interfaces);
    return interfaces;
  }

  private static void collect(@Nullable Class<?> type, Set<Class<?>> interfaces) {
    if (type == null || (type.isInterface() && !interfaces.add(type))) {
      return;
    }
    collect(type.getSuperclass(), interfaces);
    for (Class<?> each : type.getInterfaces()) {
      collect(each, interfaces);
    }
  }
}
