package org.dfra.core.policy;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.core.policy.method.CalledMethod;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.MethodKind;
import org.jspecify.annotations.Nullable;

/**
 * Which calls a rule is about.
 *
 * @param interfaces the method is one of these interfaces', and the called object has the
 *     interface; empty for all
 * @param methods names of methods; empty for all
 * @param kinds kinds of methods; empty for all
 * @param robots names of the robots that the called objects belong to
 * @param objects names of the called objects
 */
record CallCriteria(
    List<CataloguedInterface> interfaces,
    Set<String> methods,
    Set<MethodKind> kinds,
    NamePattern robots,
    NamePattern objects) {

  CallCriteria {
    interfaces = List.copyOf(interfaces);
    methods = Set.copyOf(methods);
    kinds = Set.copyOf(kinds);
  }

  /**
   * Why it is not about a call, as a part of a sentence; null if it is.
   *
   * @param robot the robot that the called object belongs to; empty if to none
   * @param object name of the called object; empty if it has none
   */
  @Nullable String mismatch(CalledMethod method, String robot, String object, Effect effect) {
    if (!interfaces.isEmpty()
        && interfaces.stream()
            .noneMatch(each -> method.isOf(each, effect == PolicyRule.Effect.DENY))) {
      return "the method does not belong to "
          + interfaces.stream()
              .map(CataloguedInterface::simpleName)
              .collect(Collectors.joining(" or "));
    }
    if (!methods.isEmpty() && !methods.contains(method.name())) {
      return "the method is "
          + method.name()
          + ", not "
          + methods.stream().sorted().collect(Collectors.joining(" or "));
    }
    if (!kinds.isEmpty() && !kinds.contains(method.kind())) {
      return "the method's kind is "
          + method.kind().text()
          + ", not "
          + kinds.stream().sorted().map(MethodKind::text).collect(Collectors.joining(" or "));
    }
    if (!robots.matches(robot)) {
      return "the robot is " + (robot.isEmpty() ? "not given" : robot) + ", not " + robots;
    }
    return objects.matches(object)
        ? null
        : "the object is " + (object.isEmpty() ? "not given" : object) + ", not " + objects;
  }
}
