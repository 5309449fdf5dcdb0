package org.dfra.core.policy.method;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.InterfaceCatalogue.DeclaredKind;
import org.jspecify.annotations.Nullable;

/**
 * A method of an object, as rules see it.
 *
 * @param interfaces full names of the object's interfaces that have the method
 * @param name of the method
 * @param isClassKnown whether these are all such interfaces. If only one interface of the object is
 *     known, its class may have others, which extend that one
 */
public record CalledMethod(
    Set<String> interfaces, String name, MethodKind kind, boolean isClassKnown) {

  /** Copies the set. */
  public CalledMethod {
    interfaces = Set.copyOf(interfaces);
  }

  /**
   * A method that was found by reflection.
   *
   * @param type the object's class, or one of its interfaces if no more is known
   */
  public static CalledMethod of(Class<?> type, Method method) {
    Set<String> interfaces =
        MethodKinds.interfaces(type).stream()
            .filter(
                each ->
                    Arrays.stream(each.getMethods())
                        .anyMatch(own -> MethodKinds.isSame(own, method)))
            .map(Class::getName)
            .collect(Collectors.toSet());
    return new CalledMethod(
        interfaces, method.getName(), MethodKinds.of(type, method).kind(), !type.isInterface());
  }

  /**
   * A method of an interface of a catalogue.
   *
   * @param name one of the interface's {@link CataloguedInterface#methods}
   * @throws IllegalArgumentException if the interface has no such method
   */
  public static CalledMethod of(
      CataloguedInterface type, String name, InterfaceCatalogue catalogue) {
    Set<String> names = new LinkedHashSet<>(type.superinterfaces());
    names.add(type.name());
    Set<String> interfaces = new LinkedHashSet<>();
    @Nullable MethodKind kind = null;
    for (String each : names) {
      CataloguedInterface known =
          each.equals(type.name()) ? type : catalogue.find(each).orElse(type);
      if (known.methods().contains(name)) {
        interfaces.add(each);
        @Nullable DeclaredKind declared = known.declared().get(name);
        if (declared != null && (kind == null || declared.kind().compareTo(kind) > 0)) {
          kind = declared.kind();
        }
      }
    }
    if (kind == null) {
      throw new IllegalArgumentException(type.simpleName() + " has no method \"" + name + "\"");
    }
    return new CalledMethod(interfaces, name, kind, false);
  }

  /**
   * Whether it is a method of an interface, as far as a rule must know for its effect.
   *
   * @param isDenial whether the rule denies: then it is one if it may be
   */
  public boolean isOf(CataloguedInterface named, boolean isDenial) {
    return interfaces.contains(named.name())
        || (isDenial
            && !isClassKnown
            && named.superinterfaces().stream().anyMatch(interfaces::contains));
  }
}
