package org.dfra.core.config;

import java.util.List;
import java.util.Optional;

/**
 * One service group: the modules that share one JVM, and fail together when it fails.
 *
 * @param name name of the group, unique on its robot, in lower_snake_case
 * @param jvmOptions options of the group's JVM, in the order written, e.g. {@code -Xmx64m}
 * @param registrar the robot's own lookup service, if this group hosts it
 * @param modules the group's modules, in the order written
 * @param place its place in the configuration
 */
public record GroupDescription(
    String name,
    List<String> jvmOptions,
    Optional<RegistrarDescription> registrar,
    List<ModuleDescription> modules,
    Place place) {

  public GroupDescription {
    jvmOptions = jvmOptions.stream().map(String::strip).toList();
    modules = List.copyOf(modules);
    DescriptionRules.require(place, DescriptionRules.name("group", name));
    if (jvmOptions.stream().anyMatch(String::isEmpty)) {
      throw new ConfigurationException(
          place + ": group " + name + " has an empty JVM option; write one or leave it out");
    }
  }
}
