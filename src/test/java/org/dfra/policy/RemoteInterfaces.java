package org.dfra.policy;

import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.rmi.Remote;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dfra.build.MainClassNames;
import org.dfra.core.policy.method.MethodKinds;

/** All remote interfaces that programs of DFRA call, as they are found in the class files. */
final class RemoteInterfaces {

  /** They are in demonstrations and benchmarks, and never in a robot's processes. */
  static final Set<String> NOT_ON_ROBOTS =
      Set.of(
          "org.dfra.benchmarks.call.EchoService",
          "org.dfra.benchmarks.micro.CallBenchmark$RangeSource",
          "org.dfra.benchmarks.secure.RevocationProbe",
          "org.dfra.examples.foundation.ProcessIdService");

  /** No class of DFRA has them as a type, but its processes export objects with them. */
  private static final List<String> BY_NAME =
      List.of("com.sun.jini.reggie.Registrar", "net.jini.security.proxytrust.ProxyTrust");

  /** The remote interfaces, by name. */
  static final List<Class<?>> ALL = find();

  /**
   * These and all that they extend, except {@link Remote} and other interfaces without methods of
   * their own that clients call.
   */
  static final List<Class<?>> WITH_SUPERINTERFACES =
      ALL.stream()
          .flatMap(each -> MethodKinds.interfaces(each).stream())
          .filter(each -> each != Remote.class && each != java.util.EventListener.class)
          .distinct()
          .sorted(Comparator.comparing(Class::getName))
          .toList();

  private RemoteInterfaces() {}

  /** Reads names from the class path and loads the classes, which takes a fifth of an analysis. */
  private static List<Class<?>> find() {
    Set<Class<?>> found = new TreeSet<>(Comparator.comparing(Class::getName));
    BY_NAME.forEach(each -> found.add(load(each)));
    for (String folder : List.of("org/dfra", "java/rmi/activation")) {
      for (String name : MainClassNames.below(folder)) {
        Class<?> type = load(name);
        Stream.concat(Stream.of(type), MethodKinds.interfaces(type).stream())
            .filter(each -> each.isInterface() && Remote.class.isAssignableFrom(each))
            .filter(each -> each != Remote.class)
            .filter(each -> !NOT_ON_ROBOTS.contains(each.getName()))
            .forEach(found::add);
      }
    }
    return List.copyOf(found);
  }

  static Class<?> load(String name) {
    try {
      return Class.forName(name, false, RemoteInterfaces.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      throw new AssertionError(name + " is not on the class path of this test", e);
    }
  }

  /** The methods that an interface declares and that can be called. */
  static List<Method> declared(Class<?> type) {
    return Arrays.stream(type.getDeclaredMethods())
        .filter(each -> !each.isSynthetic() && !Modifier.isStatic(each.getModifiers()))
        .filter(each -> !Modifier.isPrivate(each.getModifiers()))
        .toList();
  }
}
