package org.dfra.core.config;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.dfra.core.config.RobotXml.RobotXmlSchema;
import org.jdom2.Element;
import org.jspecify.annotations.Nullable;

/** Reads one {@code <module>}: its properties, and the XML's overrides. */
final class ModuleReader {

  /** Suffix of parameters whose value is a file name. */
  private static final String FILE = "_file";

  private final Path file;
  private final Element element;
  private final XmlValues values;
  private final ConfigurationFaults faults;
  private final @Nullable String name;
  private final String label;
  private final @Nullable PropertiesReader reader;
  private final ModuleProperties properties;

  ModuleReader(
      Path file,
      Element element,
      XmlValues values,
      Substitution substitution,
      ConfigurationFaults faults) {
    this.file = file;
    this.element = element;
    this.values = values;
    this.faults = faults;
    this.name = values.name(element);
    this.label = name == null ? "module" : "module " + name;
    Path path =
        existing(
            "properties", values.attribute(element, "properties"), file, values.place(element));
    this.reader = path == null ? null : new PropertiesReader(path, substitution, faults);
    this.properties = reader == null ? new ModuleProperties(file, Map.of()) : reader.read();
  }

  /** The module's name; null if it has none. */
  @Nullable String name() {
    return name;
  }

  /** The module; empty, with the reasons among the faults, if there is any fault so far. */
  Optional<ModuleDescription> module(@Nullable String robot) {
    String server = className(ModuleProperties.SERVER);
    String proxy = className(ModuleProperties.PROXY);
    String implementation = className(ModuleProperties.IMPLEMENTATION);
    String configuration = configuration();
    List<String> codebase = codebase();
    boolean restart = values.restart(element);
    Map<String, Parameters.Value> parameters = parameters(implementation);
    if (!faults.isEmpty()
        || robot == null
        || name == null
        || server == null
        || proxy == null
        || implementation == null) {
      return Optional.empty();
    }
    return Optional.of(
        new ModuleDescription(
            robot,
            name,
            server,
            proxy,
            implementation,
            configuration,
            codebase,
            restart,
            new Parameters(robot + "/" + name, parameters),
            values.place(element)));
  }

  private @Nullable String className(String key) {
    Optional<Parameters.Value> inProperties = properties.find(key);
    boolean inXml = element.getAttributeValue(key) != null;
    String text =
        inXml
            ? values.attribute(element, key)
            : inProperties.map(Parameters.Value::text).orElse(null);
    if (text == null && !inXml && !mayHold(key)) {
      values.check(element, missing(key));
    } else if (text != null) {
      SourceLocation place = inXml ? values.place(element) : inProperties.orElseThrow().place();
      String fault = DescriptionRules.className(label, key, text);
      if (fault != null) {
        faults.add(place, fault);
      }
    }
    return text;
  }

  private String missing(String key) {
    return label
        + " has no "
        + key
        + "; write "
        + (reader == null
            ? key + "=\"<class name>\" in it, or name properties that hold it"
            : key + "=<class name> in " + properties.source());
  }

  /** Whether the properties contain a key, or might if they could be read. */
  private boolean mayHold(String key) {
    return reader == null
        ? element.getAttributeValue("properties") != null
        : !reader.isReadable() || reader.hasKey(key);
  }

  private @Nullable String configuration() {
    List<String> named = files(ModuleProperties.CONFIGURATION, List::of);
    return named.isEmpty() ? null : named.get(0);
  }

  private List<String> codebase() {
    return files(
        ModuleProperties.CODEBASE,
        text ->
            Arrays.stream(text.split(","))
                .map(String::strip)
                .filter(item -> !item.isEmpty())
                .distinct()
                .toList());
  }

  /**
   * The files that a key names, in the XML or else in the properties, absolute; missing files are
   * omitted and reported as faults.
   *
   * @param names splits the key's value
   */
  private List<String> files(String key, Function<String, List<String>> names) {
    boolean inXml = element.getAttributeValue(key) != null;
    Optional<Parameters.Value> inProperties = properties.find(key);
    String text =
        inXml
            ? values.attribute(element, key)
            : inProperties.map(Parameters.Value::text).orElse(null);
    if (text == null) {
      return List.of();
    }
    Path base = inXml ? file : properties.source();
    SourceLocation place = inXml ? values.place(element) : inProperties.orElseThrow().place();
    return names.apply(text).stream()
        .map(name -> existing(key, name, base, place))
        .filter(Objects::nonNull)
        .map(path -> path.toAbsolutePath().normalize().toString())
        .toList();
  }

  /**
   * A file named relative to another one; null if it is not named, or missing, which is reported as
   * a fault.
   */
  private @Nullable Path existing(
      String what, @Nullable String text, Path base, SourceLocation place) {
    if (text == null) {
      return null;
    }
    try {
      Path path = base.resolveSibling(text).normalize();
      if (!Files.isRegularFile(path) && path.getFileName() != null) {
        String old = path.getFileName().toString();
        path =
            path.resolveSibling(RenamedNames.resolve(RenamedNames.FILES, place, "the file", old));
      }
      if (Files.isRegularFile(path)) {
        return path;
      }
    } catch (InvalidPathException e) {
      // an invalid path is not a file either
    }
    String named = "the " + what + " file \"" + text + "\" of " + label;
    faults.add(place, named + " does not exist; name one, relative to " + base);
    return null;
  }

  /** The parameters; a file's name is made absolute, since the module runs elsewhere. */
  private Map<String, Parameters.Value> parameters(@Nullable String implementation) {
    String scope = implementation == null ? "" : implementation;
    Map<String, Parameters.Value> parameters = new TreeMap<>();
    RenamedNames.resolveParameters(scope, properties.parameters(), faults)
        .forEach((name, value) -> parameters.put(name, found(name, value, properties.source())));
    XmlValues.UniqueNames names = values.uniqueNames();
    Map<String, Parameters.Value> inXml = new TreeMap<>();
    for (Element child : element.getChildren("parameter", RobotXmlSchema.NAMESPACE)) {
      String parameter = values.name(child);
      String value = values.attribute(child, "value");
      if (parameter != null) {
        names.requireFirst(
            child, parameter, "parameter " + parameter + " of " + label, "delete one");
        if (value != null) {
          inXml.put(parameter, new Parameters.Value(value, values.place(child)));
        }
      }
    }
    RenamedNames.resolveParameters(scope, inXml, faults)
        .forEach((name, value) -> parameters.put(name, found(name, value, file)));
    return parameters;
  }

  private Parameters.Value found(String name, Parameters.Value value, Path base) {
    if (!name.endsWith(FILE)) {
      return value;
    }
    @Nullable Path path = existing(name, value.text(), base, value.place());
    return path == null
        ? value
        : new Parameters.Value(path.toAbsolutePath().normalize().toString(), value.place());
  }
}
