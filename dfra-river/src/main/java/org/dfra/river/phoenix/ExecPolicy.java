package org.dfra.river.phoenix;

import java.nio.file.Path;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * What a group descriptor may make the daemon execute. Each entry is a text in which {@code *}
 * stands for any run of characters.
 *
 * @param customGroups whether a descriptor may name its own group class, location or data
 * @param commands permitted command paths
 * @param options permitted options
 * @param properties permitted {@code name=value} system properties
 */
record ExecPolicy(
    boolean customGroups, List<String> commands, List<String> options, List<String> properties) {

  /** The daemon's own java with any option and property. */
  static final ExecPolicy DEFAULT =
      new ExecPolicy(false, List.of(ownJava()), List.of("*"), List.of("*"));

  /** The java command of this virtual machine, which also stands in for none. */
  static String ownJava() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /**
   * Refuses a descriptor that asks for more than is permitted.
   *
   * @throws ActivationException naming what is refused and the entry that would permit it
   */
  void check(ActivationGroupDesc desc) throws ActivationException {
    if (!customGroups
        && (desc.getClassName() != null || desc.getLocation() != null || desc.getData() != null)) {
      throw new ActivationException(
          "the group descriptor names its own group class, location or data, which is not "
              + "permitted; leave them null or set customGroups in phoenix's configuration");
    }
    ActivationGroupDesc.@Nullable CommandEnvironment command = desc.getCommandEnvironment();
    if (command != null) {
      if (command.getCommandPath() != null) {
        require("command", command.getCommandPath(), commands, "permittedCommands");
      }
      for (String option : command.getCommandOptions()) {
        require("option", option, options, "permittedOptions");
      }
    }
    if (desc.getPropertyOverrides() != null) {
      for (Map.Entry<Object, Object> each : desc.getPropertyOverrides().entrySet()) {
        require(
            "property", each.getKey() + "=" + each.getValue(), properties, "permittedProperties");
      }
    }
  }

  private static void require(String what, String text, List<String> permitted, String entry)
      throws ActivationException {
    if (permitted.stream().noneMatch(pattern -> matches(pattern, text))) {
      throw new ActivationException(
          "the group descriptor's "
              + what
              + " "
              + text
              + " is not permitted; add it to "
              + entry
              + " in phoenix's configuration");
    }
  }

  private static boolean matches(String pattern, String text) {
    String regex =
        List.of(pattern.split("\\*", -1)).stream()
            .map(Pattern::quote)
            .collect(Collectors.joining(".*"));
    return Pattern.compile(regex, Pattern.DOTALL).matcher(text).matches();
  }
}
