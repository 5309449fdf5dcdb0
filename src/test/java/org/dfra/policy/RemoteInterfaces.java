package org.dfra.policy;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.rmi.Remote;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dfra.build.MainClasses;
import org.dfra.core.policy.MethodKinds;

/** All remote interfaces that programs of DFRA call, as they are found in the class files. */
final class RemoteInterfaces {

  /** They are in demonstrations and benchmarks, and never in a robot's processes. */
  static final Set<String> NOT_ON_ROBOTS =
      Set.of(
          "org.dfra.benchmarks.call.EchoService",
          "org.dfra.benchmarks.micro.CallBenchmark$RangeSource",
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

  private static List<Class<?>> find() {
    Set<String> names = new TreeSet<>(BY_NAME);
    JavaClasses activation =
        new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("java.rmi.activation");
    for (JavaClass each : Stream.concat(MainClasses.ALL.stream(), activation.stream()).toList()) {
      Stream.concat(Stream.of(each), each.getAllRawInterfaces().stream())
          .filter(JavaClass::isInterface)
          .filter(type -> type.isAssignableTo(Remote.class))
          .map(JavaClass::getName)
          .filter(name -> !name.equals(Remote.class.getName()))
          .filter(name -> !NOT_ON_ROBOTS.contains(name))
          .forEach(names::add);
    }
    return names.stream().<Class<?>>map(RemoteInterfaces::load).toList();
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
