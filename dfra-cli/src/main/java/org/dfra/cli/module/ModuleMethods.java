package org.dfra.cli.module;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Parameter;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.core.config.NearestName;
import org.dfra.event.ModuleListener;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;

/** The methods that a module offers its clients, called by name. */
final class ModuleMethods {

  private final Module module;
  private final List<Method> methods;

  ModuleMethods(Module module) {
    this.module = module;
    this.methods =
        ModuleKinds.interfaces(module).stream()
            .flatMap(kind -> Arrays.stream(kind.getMethods()))
            .filter(ModuleMethods::canBeWritten)
            .collect(
                Collectors.toMap(
                    ModuleMethods::signature, each -> each, ModuleMethods::moreSpecial))
            .values()
            .stream()
            .sorted(Comparator.comparing(Method::getName).thenComparing(Method::getParameterCount))
            .toList();
  }

  /**
   * Whether its arguments can be written on a command line, and its result is not bound to this
   * process.
   */
  private static boolean canBeWritten(Method method) {
    return !AutoCloseable.class.isAssignableFrom(method.getReturnType())
        && Arrays.stream(method.getParameterTypes())
            .noneMatch(type -> ModuleListener.class.isAssignableFrom(type) || type == Object.class);
  }

  private static Method moreSpecial(Method one, Method other) {
    return one.getReturnType().isAssignableFrom(other.getReturnType()) ? other : one;
  }

  /** {@code name(Type name, …)}. */
  static String signature(Method method) {
    return Arrays.stream(method.getParameters())
        .map(each -> name(each.getParameterizedType()) + " " + each.getName())
        .collect(Collectors.joining(", ", method.getName() + "(", ")"));
  }

  /** A type without packages. */
  static String name(Type type) {
    return type.getTypeName().replaceAll("(\\w+\\.)+", "");
  }

  /** All methods, in alphabetical order. */
  List<Method> methods() {
    return methods;
  }

  /**
   * Calls a method.
   *
   * @param arguments as text
   * @return its result; null if it returns nothing
   * @throws Exception thrown by the method
   */
  @Nullable Object invoke(String name, List<String> arguments) throws Exception {
    Method method = method(name, arguments.size());
    try {
      return method.invoke(module, values(method, arguments));
    } catch (InvocationTargetException e) {
      throw e.getCause() instanceof Exception thrown ? thrown : e;
    }
  }

  private Method method(String name, int arguments) {
    List<Method> named = methods.stream().filter(each -> each.getName().equals(name)).toList();
    if (named.isEmpty()) {
      throw new CommandFailure(
          ExitCode.NOT_FOUND,
          "the module has no method "
              + name
              + NearestName.hint(
                  name,
                  methods.stream().map(Method::getName).distinct().toList(),
                  "; leave the method out to see what there is"));
    }
    return named.stream()
        .filter(each -> each.getParameterCount() == arguments)
        .findFirst()
        .orElseThrow(
            () ->
                new CommandFailure(
                    ExitCode.USAGE_ERROR,
                    "there is no "
                        + name
                        + " with "
                        + arguments
                        + " arguments; there is "
                        + named.stream()
                            .map(ModuleMethods::signature)
                            .collect(Collectors.joining(", "))));
  }

  private static Object[] values(Method method, List<String> arguments) {
    List<Object> values = new ArrayList<>();
    Type[] types = method.getGenericParameterTypes();
    Parameter[] parameters = method.getParameters();
    for (int i = 0; i < types.length; i++) {
      try {
        values.add(CommandOutput.parseValue(arguments.get(i), types[i]));
      } catch (IllegalArgumentException e) {
        throw new CommandFailure(
            ExitCode.USAGE_ERROR, parameters[i].getName() + ": " + e.getMessage(), e);
      }
    }
    return values.toArray();
  }
}
