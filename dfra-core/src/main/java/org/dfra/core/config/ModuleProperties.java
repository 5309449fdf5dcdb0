package org.dfra.core.config;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * A module's properties: its classes, and the default parameters of its driver. The syntax is that
 * of {@link Properties}, the encoding UTF-8.
 *
 * @param source the file that was read
 * @param values the values by key, with variables substituted, in file order
 */
record ModuleProperties(Path source, Map<String, Parameters.Value> values) {

  /** Key of the module server's class. */
  public static final String SERVER = "server";

  /** Key of the smart proxy's class. */
  public static final String PROXY = "proxy";

  /** Key of the driver's class. */
  public static final String IMPLEMENTATION = "implementation";

  /** Key of the module's Jini configuration, a path relative to the properties file. */
  public static final String CONFIGURATION = "configuration";

  /**
   * Key of the jars that clients without the module's classes download, paths relative to the
   * properties file, separated by commas.
   */
  public static final String CODEBASE = "codebase";

  /** Prefix of a parameter's key; the parameter's name follows. */
  public static final String PARAMETER = "parameter.";

  /** All keys; {@link #PARAMETER} stands for all keys with this prefix. */
  public static final List<String> KEYS =
      List.of(SERVER, PROXY, IMPLEMENTATION, CONFIGURATION, CODEBASE, PARAMETER);

  public ModuleProperties {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  /**
   * Reads a file; variables come from system properties and the environment.
   *
   * @throws ConfigurationException with every fault in it, a line each
   */
  public static ModuleProperties read(Path file) {
    return read(file, Substitution::environment);
  }

  /**
   * Reads a file.
   *
   * @param lookup returns the value of a variable, or null if it is not set
   * @throws ConfigurationException with every fault in it, a line each
   */
  public static ModuleProperties read(Path file, Function<String, @Nullable String> lookup) {
    ConfigurationFaults faults = new ConfigurationFaults();
    PropertiesReader reader = new PropertiesReader(file, new Substitution(lookup, faults), faults);
    ModuleProperties properties = reader.read();
    faults.throwIfAny();
    return properties;
  }

  /** The value of a key. */
  public Optional<Parameters.Value> find(String key) {
    return Optional.ofNullable(values.get(key));
  }

  /** The parameters, by name without {@link #PARAMETER}. */
  public Map<String, Parameters.Value> parameters() {
    return values.entrySet().stream()
        .filter(entry -> entry.getKey().startsWith(PARAMETER))
        .collect(
            Collectors.toMap(
                entry -> entry.getKey().substring(PARAMETER.length()), Map.Entry::getValue));
  }
}
