package org.dfra.core.config;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The old names that still work until the next release: the only table of aliases, a resource of
 * this package. Each use of an old name causes one warning, which names file, line and new name.
 *
 * <p>Names of attributes and parameters differ between elements, implementations and devices, so
 * each has a scope.
 */
public final class RenamedNames {

  /** Scope of the keys of a module's properties. */
  static final String PROPERTIES = "properties";

  /** Scope of the files that DFRA brings, used if a file of the old name does not exist. */
  static final String FILES = "file";

  /**
   * Scope of system properties; a name that ends with a dot stands for all names that follow it.
   */
  private static final String SYSTEM_PROPERTIES = "system property";

  /** Scope of the parameters of every implementation. */
  private static final String ANY_IMPLEMENTATION = "*";

  private static final String TABLE = "renamed-names.tsv";

  /** Recorded parameters can come from another computer, which must not fill the memory. */
  private static final int MAX_WARNINGS = 1000;

  private static final Logger LOG = LoggerFactory.getLogger(RenamedNames.class);

  private static final Map<String, Map<String, String>> NAMES = read();

  private static final Set<String> WARNED = ConcurrentHashMap.newKeySet();

  private static volatile Consumer<String> receiver = LOG::warn;

  private RenamedNames() {}

  /** Scope of the attributes of an XML element. */
  public static String attributesOf(String element) {
    return "<" + element + ">";
  }

  /** Scope of the parameters of a kind of device in a simulated world. */
  public static String parametersOfDevice(String kind) {
    return "device " + kind;
  }

  /** Sends all later warnings to a receiver instead of the log. */
  public static void onWarning(Consumer<String> receiver) {
    RenamedNames.receiver = receiver;
  }

  /** Sends all later warnings to the log, as at the start. */
  public static void logWarnings() {
    receiver = LOG::warn;
  }

  /** The new name; empty if the name is no old one in this scope. */
  public static Optional<String> find(String scope, String name) {
    return Optional.ofNullable(scope(scope).get(name));
  }

  /**
   * The new name of a parameter, or the new {@code name=value} of a value.
   *
   * @param implementation full name of the module's implementation class
   */
  static Optional<String> findParameter(String implementation, String name) {
    return find(implementation, name).or(() -> find(ANY_IMPLEMENTATION, name));
  }

  /**
   * The new name of a parameter or procedure of a running module, whose class may be unknown here.
   * Warns if the name is an old one.
   *
   * @param place where the old name was used, for the warning
   * @param known the module's present names
   * @return the name itself if it is present or unknown
   */
  public static String resolve(String place, String what, String name, Collection<String> known) {
    if (known.contains(name)) {
      return name;
    }
    Optional<String> renamed =
        NAMES.values().stream()
            .filter(scope -> scope.containsKey(name))
            .map(scope -> scope.get(name))
            .filter(known::contains)
            .findFirst();
    renamed.ifPresent(now -> warn(place, what, name, now));
    return renamed.orElse(name);
  }

  /**
   * The new name of a name in a file. Warns if the name is an old one.
   *
   * @param what the named object, such as {@code the parameter}
   */
  public static String resolve(String scope, SourceLocation place, String what, String name) {
    Optional<String> renamed = find(scope, name);
    renamed.ifPresent(now -> warn(place.toString(), what, name, now));
    return renamed.orElse(name);
  }

  /**
   * Parameters by their new names, with the new ones of their values. Warns of each old name.
   *
   * @param implementation full name of the module's implementation class
   * @param faults receives a fault for each parameter that is set by its old and its new name
   */
  static Map<String, Parameters.Value> resolveParameters(
      String implementation, Map<String, Parameters.Value> written, ConfigurationFaults faults) {
    Map<String, Parameters.Value> resolved = new TreeMap<>();
    written.forEach(
        (name, value) -> {
          String now = findParameter(implementation, name).orElse(name);
          if (!now.equals(name)) {
            warn(value.place().toString(), "the parameter", name, now);
          }
          if (now.equals(name) || !written.containsKey(now)) {
            resolved.put(now, resolveValue(implementation, now, value));
          } else {
            faults.add(
                value.place(),
                "the parameter "
                    + name
                    + " is the old name of "
                    + now
                    + ", which is set in line "
                    + written.get(now).place().line()
                    + "; delete this one");
          }
        });
    return resolved;
  }

  private static Parameters.Value resolveValue(
      String implementation, String name, Parameters.Value value) {
    String text = resolveValue(implementation, value.place().toString(), name, value.text());
    return text.equals(value.text()) ? value : new Parameters.Value(text, value.place());
  }

  /**
   * The new form of a parameter's value. Warns if the value is an old one.
   *
   * @param implementation full name of the module's implementation class
   * @param place where the value was set, for the warning
   * @param name the parameter's new name
   */
  public static String resolveValue(String implementation, String place, String name, String text) {
    Optional<String> renamed =
        findParameter(implementation, name + "=" + text.strip())
            .map(now -> now.substring(name.length() + 1));
    renamed.ifPresent(now -> warn(place, "the value of " + name, text.strip(), now));
    return renamed.orElse(text);
  }

  /**
   * The value of a system property, also under its old name.
   *
   * @param properties the system properties
   * @param name the new name
   */
  public static @Nullable String property(Properties properties, String name) {
    String value = properties.getProperty(name);
    for (Map.Entry<String, String> each : scope(SYSTEM_PROPERTIES).entrySet()) {
      String now = each.getValue();
      if (value == null && (now.endsWith(".") ? name.startsWith(now) : name.equals(now))) {
        String old = each.getKey() + name.substring(now.length());
        value = properties.getProperty(old);
        if (value != null) {
          warn("this process", "the system property", old, name);
        }
      }
    }
    return value;
  }

  /** A recorded option of a JVM with the new name of its system property. Does not warn. */
  public static String resolveOption(String option) {
    for (Map.Entry<String, String> each : scope(SYSTEM_PROPERTIES).entrySet()) {
      String old = "-D" + each.getKey();
      if (option.startsWith(old.endsWith(".") ? old : old + "=")) {
        return "-D" + each.getValue() + option.substring(old.length());
      }
    }
    return option;
  }

  /** The old name of a new one in a scope; null if it has none. */
  public static @Nullable String oldName(String scope, String name) {
    return scope(scope).entrySet().stream()
        .filter(each -> each.getValue().equals(name))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElse(null);
  }

  /** Whether anything of this scope has a new name. */
  static boolean hasScope(String scope) {
    return NAMES.containsKey(scope);
  }

  private static Map<String, String> scope(String name) {
    return NAMES.getOrDefault(name, Map.of());
  }

  /** Warns of the use of an old name, once per place in this process. */
  public static void warn(String place, String what, String old, String now) {
    String warning =
        place
            + ": "
            + what
            + " "
            + old
            + " is now called "
            + now
            + "; the old name works until the next release.";
    if (WARNED.size() < MAX_WARNINGS && WARNED.add(warning)) {
      receiver.accept(warning);
    }
  }

  private static Map<String, Map<String, String>> read() {
    Map<String, Map<String, String>> names = new HashMap<>();
    for (String line : text().lines().filter(each -> !each.startsWith("#")).toList()) {
      String[] columns = line.split("\t", -1);
      names
          .computeIfAbsent(columns[0], scope -> new HashMap<>())
          // The JDK's XML validator compares interned names by identity.
          .put(columns[1], columns[2].intern());
    }
    return names;
  }

  private static String text() {
    try (InputStream in = RenamedNames.class.getResourceAsStream(TABLE)) {
      if (in == null) {
        throw new IllegalStateException(TABLE + " is missing in this jar; build it again");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
