package org.dfra.river.phoenix;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/**
 * What a group descriptor may make the daemon execute. In the first three lists {@code *} matches
 * any characters; the other lists are compared literally.
 *
 * <p>An option is permitted if a list contains it, if phoenix's own virtual machine was started
 * with it, or if a file contains it as a line. An option {@code -Dname=value} is also permitted if
 * {@code name=value} is. A class path and its option are one entry: {@code -cp PATH}.
 *
 * @param customGroups whether a descriptor may name its own group class, location or data
 * @param commands permitted command paths
 * @param options permitted options
 * @param properties permitted {@code name=value} system properties
 * @param classPaths permitted class paths
 * @param files private files of phoenix's user that permit further options, one a line; they are
 *     read at each registration and need not exist
 */
record ExecPolicy(
    boolean customGroups,
    List<String> commands,
    List<String> options,
    List<String> properties,
    List<String> classPaths,
    List<Path> files) {

  /** The daemon's own java and class path, and the {@link StandardExecPermissions}. */
  static final ExecPolicy DEFAULT =
      new ExecPolicy(
          false,
          List.of(ownJava()),
          StandardExecPermissions.OPTIONS,
          StandardExecPermissions.PROPERTIES,
          List.of(System.getProperty("java.class.path")),
          List.of());

  /** Options whose value is the next argument. */
  private static final Set<String> CLASS_PATH = Set.of("-cp", "-classpath", "--class-path");

  private static final String PROPERTY = "-D";

  /** The java command of this virtual machine; also used if a descriptor names none. */
  static String ownJava() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /**
   * Refuses a descriptor that requests more than is permitted.
   *
   * @throws ActivationException naming the refused part, the group, and where to permit it
   */
  void check(ActivationGroupDesc desc) throws ActivationException {
    String group = name(desc);
    if (!customGroups
        && (desc.getClassName() != null || desc.getLocation() != null || desc.getData() != null)) {
      throw new ActivationException(
          "the descriptor of "
              + group
              + " names its own group class, location or data, which is not permitted; leave them"
              + " null or set customGroups in phoenix's configuration");
    }
    ActivationGroupDesc.@Nullable CommandEnvironment command = desc.getCommandEnvironment();
    if (command != null) {
      String path = command.getCommandPath();
      if (path != null && !matchesAny(commands, path)) {
        throw refused("command", path, group, "permittedCommands", false);
      }
      checkOptions(group, List.of(command.getCommandOptions()));
    }
    if (desc.getPropertyOverrides() != null) {
      List<String> verbatim = verbatim();
      for (Map.Entry<Object, Object> each : desc.getPropertyOverrides().entrySet()) {
        String text = each.getKey() + "=" + each.getValue();
        if (!matchesAny(properties, text) && !verbatim.contains(PROPERTY + text)) {
          throw refused("property", text, group, "permittedProperties", true);
        }
      }
    }
  }

  private void checkOptions(String group, List<String> given) throws ActivationException {
    List<String> verbatim = verbatim();
    int i = 0;
    while (i < given.size()) {
      String option = given.get(i++);
      if (CLASS_PATH.contains(option) && i < given.size()) {
        String path = given.get(i++);
        boolean isPermitted =
            classPaths.contains(path)
                || verbatim.contains(classPathLine(path))
                || (matchesAny(options, option) && matchesAny(options, path));
        if (!isPermitted) {
          throw refused("class path", path, group, "permittedClassPaths", true);
        }
      } else if (!matchesAny(options, option) && !verbatim.contains(option)) {
        if (!option.startsWith(PROPERTY)) {
          throw refused("option", option, group, "permittedOptions", true);
        }
        String property = option.substring(PROPERTY.length());
        if (!matchesAny(properties, property)) {
          throw refused("property", property, group, "permittedProperties", true);
        }
      }
    }
  }

  /** The line with which a file permits a class path. */
  static String classPathLine(String path) {
    return "-cp " + path;
  }

  /** Literally permitted options: those of phoenix's own machine and of the files. */
  private List<String> verbatim() throws ActivationException {
    List<String> all = new ArrayList<>(ManagementFactory.getRuntimeMXBean().getInputArguments());
    for (Path file : files) {
      if (Files.exists(file)) {
        try {
          PrivateFiles.requireFile(file);
          Files.readAllLines(file, StandardCharsets.UTF_8).stream()
              .map(String::strip)
              .filter(line -> line.startsWith("-")) // the others are blank, or comments
              .forEach(all::add);
        } catch (IOException e) {
          throw new ActivationException(
              "the options that " + file + " permits cannot be read: " + e.getMessage(), e);
        }
      }
    }
    return all;
  }

  private ActivationException refused(
      String what, String text, String group, String entry, boolean byFile) {
    return new ActivationException(
        what
            + " "
            + text
            + " of "
            + group
            + " is not permitted; leave it out, or add it to "
            + entry
            + " in phoenix's configuration"
            + (byFile && !files.isEmpty()
                ? " or as a line to " + files.get(files.size() - 1)
                : ""));
  }

  private static String name(ActivationGroupDesc desc) {
    @Nullable Properties properties = desc.getPropertyOverrides();
    @Nullable String name = properties == null ? null : properties.getProperty(Phoenix.GROUP_NAME);
    return name == null ? "a group without a name" : "group " + name;
  }

  private static boolean matchesAny(List<String> patterns, String text) {
    return patterns.stream().anyMatch(pattern -> matches(pattern, text));
  }

  private static boolean matches(String pattern, String text) {
    String regex =
        List.of(pattern.split("\\*", -1)).stream()
            .map(Pattern::quote)
            .collect(Collectors.joining(".*"));
    return Pattern.compile(regex, Pattern.DOTALL).matcher(text).matches();
  }
}
