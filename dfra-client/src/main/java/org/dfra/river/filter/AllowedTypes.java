package org.dfra.river.filter;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.server.RemoteObject;
import java.rmi.server.RemoteRef;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The classes that a stream may contain. The refusals come first and cannot be overridden. Then
 * follow the allowed classes: values of the JDK, River, DFRA, classes of trusted code, and the
 * configured ones.
 */
final class AllowedTypes {

  /** Packages of the JDK, without subpackages. */
  private static final Set<String> JDK_PACKAGES =
      Set.of(
          "java.lang",
          "java.math",
          "java.time",
          "java.time.chrono",
          "java.time.zone",
          "java.util",
          "java.util.concurrent",
          "java.util.concurrent.atomic",
          "java.util.concurrent.locks",
          "java.rmi",
          "java.rmi.activation",
          "java.rmi.dgc",
          "java.rmi.registry",
          "java.rmi.server");

  private static final Set<String> JDK_CLASSES =
      Set.of(
          "java.io.Externalizable",
          "java.io.File",
          "java.io.Serializable",
          "java.lang.reflect.Proxy",
          "java.net.Inet4Address",
          "java.net.Inet6Address",
          "java.net.InetAddress",
          "java.net.InetSocketAddress",
          "java.net.URI",
          "java.security.Principal",
          "java.util.logging.Level",
          "javax.security.auth.x500.X500Principal");

  /**
   * Collections that hash or compare their contents, during deserialization or later, more often
   * than a filter can count. Each maps to the type to send in its place.
   */
  private static final Map<String, String> UNCOUNTED =
      Map.of(
          "java.util.Collections$CopiesList", "an ArrayList",
          "java.util.PriorityQueue", "an ArrayList",
          "java.util.concurrent.ConcurrentHashMap", "a HashMap",
          "java.util.concurrent.ConcurrentSkipListMap", "a TreeMap",
          "java.util.concurrent.ConcurrentSkipListSet", "a TreeSet",
          "java.util.concurrent.CopyOnWriteArraySet", "a HashSet",
          "java.util.concurrent.PriorityBlockingQueue", "an ArrayList");

  /** Handlers of the JDK and of its activation, each of which calls one object exported by JRMP. */
  private static final Set<String> JRMP_HANDLERS =
      Set.of(
          "java.rmi.server.RemoteObjectInvocationHandler",
          "java.rmi.activation.ActivatableHandler");

  /** Its serial form contains a JRMP reference; phoenix's own identities have another form. */
  private static final String ACTIVATION_ID = "java.rmi.activation.ActivationID";

  /** Packages with their subpackages. */
  private static final List<String> OURS = List.of("net.jini.", "com.sun.jini.", "org.dfra.");

  /** Known deserialization gadgets; package names end in a dot. */
  private static final List<String> REFUSED =
      List.of(
          "bsh.",
          "clojure.",
          "com.mchange.",
          "com.sun.org.apache.",
          "com.sun.rowset.",
          "com.sun.syndication.",
          "groovy.",
          "java.lang.invoke.",
          "javax.management.",
          "javax.naming.",
          "javax.script.",
          "javax.swing.",
          "javassist.",
          "org.apache.commons.beanutils.",
          "org.apache.commons.collections.",
          "org.apache.commons.collections4.",
          "org.apache.commons.fileupload.",
          "org.apache.xalan.",
          "org.codehaus.groovy.",
          "org.hibernate.",
          "org.mozilla.javascript.",
          "org.python.",
          "org.springframework.",
          "sun.reflect.",
          "sun.rmi.");

  private final List<String> patterns;
  private final boolean jrmp;
  private final ClassValue<String> reasons =
      new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> type) {
          @Nullable String reason = reason(type);
          return reason == null ? "" : reason;
        }
      };

  /** Without references to objects exported by JRMP. */
  AllowedTypes(Collection<String> patterns) {
    this(patterns, false);
  }

  /**
   * @param patterns further allowed types: a class, {@code package.*}, or {@code package.**} with
   *     all subpackages
   * @param jrmp whether references to objects exported by JRMP are allowed
   * @throws IllegalArgumentException if a pattern would allow everything, or is invalid
   */
  AllowedTypes(Collection<String> patterns, boolean jrmp) {
    for (String pattern : patterns) {
      if (!pattern.matches("[\\w$]+(\\.[\\w$]+)*(\\.\\*\\*?)?")) {
        throw new IllegalArgumentException(
            "\""
                + pattern
                + "\" is neither a class nor package.* nor package.**; correct dfra.serial.allow");
      }
    }
    this.patterns = List.copyOf(patterns);
    this.jrmp = jrmp;
  }

  /** Adds the packages of {@code types}, such as those of a remote method's parameters. */
  AllowedTypes with(Collection<Class<?>> types) {
    List<String> more = new ArrayList<>(patterns);
    types.stream()
        .map(AllowedTypes::element)
        .filter(type -> !type.isPrimitive() && type.getClassLoader() != null)
        .filter(type -> reason(type) != null && !type.getPackageName().isEmpty())
        .map(type -> type.getPackageName() + ".*")
        .distinct()
        .forEach(more::add);
    return more.size() == patterns.size() ? this : new AllowedTypes(more, jrmp);
  }

  /**
   * Checks one class.
   *
   * @throws RefusedDataException if it may not be read
   */
  void check(Class<?> type) {
    String reason = reasons.get(type);
    if (!reason.isEmpty()) {
      throw new RefusedDataException(reason);
    }
  }

  private @Nullable String reason(Class<?> named) {
    Class<?> type = element(named);
    String name = type.getName();
    if (type.isPrimitive()) {
      return null;
    }
    if (REFUSED.stream().anyMatch(name::startsWith)
        || UnicastRemoteObject.class.isAssignableFrom(type)) {
      return "refused to read class " + name + ": it is known to do harm when it is read";
    }
    @Nullable String instead = UNCOUNTED.get(name);
    if (instead != null) {
      return "refused to read class "
          + name
          + ": no filter sees how often it hashes or compares what it holds; send "
          + instead;
    }
    if (isOfJrmp(type, name) && !jrmp) {
      return "refused to read class "
          + name
          + ": it refers to an object exported by JRMP, and to read it starts a thread and opens a"
          + " connection; if this program uses such objects, set dfra.serial.jrmp=true where it is"
          + " read";
    }
    if (Proxy.isProxyClass(type)) { // its interfaces and its handler are checked separately
      return null;
    }
    // it has no instances: a proxy implements it, or an object contains it as a class
    if (type.isInterface()) {
      return null;
    }
    if (InvocationHandler.class.isAssignableFrom(type)
        && type != InvocationHandler.class
        && !JRMP_HANDLERS.contains(name)
        && !isOurs(name)
        && !isTrusted(type)) {
      return "refused to read a proxy whose handler is class "
          + name
          + ": only River's, DFRA's and trusted code's may handle one";
    }
    if (isOurs(name) || isOfTheJdk(type, name) || isTrusted(type) || isConfigured(name)) {
      return null;
    }
    return "refused to read class "
        + name
        + ": it is not among the classes that may come from outside; if your module sends it, add"
        + " its package to dfra.serial.allow where it is read";
  }

  private static boolean isOfJrmp(Class<?> type, String name) {
    return RemoteObject.class.isAssignableFrom(type)
        || (RemoteRef.class.isAssignableFrom(type) && !type.isInterface())
        || JRMP_HANDLERS.contains(name)
        || name.equals(ACTIVATION_ID);
  }

  /** The element type of an array, or the class itself. */
  static Class<?> element(Class<?> type) {
    Class<?> element = type;
    while (element.isArray()) {
      element = element.getComponentType();
    }
    return element;
  }

  private static boolean isOurs(String name) {
    return OURS.stream().anyMatch(name::startsWith);
  }

  private static boolean isTrusted(Class<?> type) {
    return type.getClassLoader() instanceof TrustedLoader;
  }

  private static boolean isOfTheJdk(Class<?> type, String name) {
    if (type.getClassLoader() != null) {
      return false;
    }
    return JDK_PACKAGES.contains(type.getPackageName())
        || JDK_CLASSES.contains(name)
        || (Throwable.class.isAssignableFrom(type) && name.startsWith("java"));
  }

  private boolean isConfigured(String name) {
    return patterns.stream().anyMatch(pattern -> matches(pattern, name));
  }

  private static boolean matches(String pattern, String name) {
    if (pattern.endsWith(".**")) {
      return name.startsWith(pattern.substring(0, pattern.length() - 2));
    }
    if (pattern.endsWith(".*")) {
      String start = pattern.substring(0, pattern.length() - 1);
      return name.startsWith(start) && name.indexOf('.', start.length()) < 0;
    }
    return name.equals(pattern) || name.startsWith(pattern + "$");
  }

  /** Parses the list of a system property; without references to objects exported by JRMP. */
  static AllowedTypes parse(String list) {
    return parse(list, false);
  }

  /** Parses the list of a system property, with or without such references. */
  static AllowedTypes parse(String list, boolean jrmp) {
    return new AllowedTypes(
        Arrays.stream(list.split(",")).map(String::trim).filter(s -> !s.isEmpty()).toList(), jrmp);
  }
}
