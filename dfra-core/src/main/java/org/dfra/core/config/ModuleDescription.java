package org.dfra.core.config;

import java.io.Serializable;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * One module, as the robot's XML and the module's properties describe it, with every variable
 * substituted. It is stored in the activation log, so it is small and contains only types of the
 * JDK and this package.
 *
 * @param robot name of the robot
 * @param name name of the module, unique on its robot, in lower_snake_case
 * @param serverClass full name of the module server's class
 * @param proxyClass full name of the smart proxy's class
 * @param driverClass full name of the driver's class
 * @param configuration absolute path of the module's Jini configuration; null for the default
 * @param codebase absolute paths of the jars that clients without the module's classes download;
 *     empty if the classes are DFRA's own or all clients have them
 * @param restart whether it is restarted at once after a crash, rather than at the next call
 * @param parameters the driver's parameters
 * @param place the module's place in the robot's XML
 */
public record ModuleDescription(
    String robot,
    String name,
    String serverClass,
    String proxyClass,
    String driverClass,
    @Nullable String configuration,
    List<String> codebase,
    boolean restart,
    Parameters parameters,
    SourceLocation place)
    implements Serializable {

  public ModuleDescription {
    codebase = List.copyOf(codebase);
    parameters = parameters.withoutOldNames(driverClass); // recorded ones may have some
    DescriptionRules.require(place, DescriptionRules.name("robot", robot));
    DescriptionRules.require(place, DescriptionRules.name("module", name));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "server", serverClass));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "proxy", proxyClass));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "implementation", driverClass));
    if (configuration != null && configuration.isBlank()) {
      throw new ConfigurationException(
          place
              + ": the configuration of module "
              + name
              + " is blank; name a file or leave it out");
    }
  }

  /** A module whose classes need not be downloaded. */
  public ModuleDescription(
      String robot,
      String name,
      String serverClass,
      String proxyClass,
      String driverClass,
      @Nullable String configuration,
      boolean restart,
      Parameters parameters,
      SourceLocation place) {
    this(
        robot,
        name,
        serverClass,
        proxyClass,
        driverClass,
        configuration,
        List.of(),
        restart,
        parameters,
        place);
  }

  /** The same module of another robot. */
  public ModuleDescription withRobot(String other) {
    return copy(other, name, driverClass, new Parameters(other + "/" + name, parameters.all()));
  }

  /** The same module with another name. */
  public ModuleDescription withName(String other) {
    return copy(robot, other, driverClass, new Parameters(robot + "/" + other, parameters.all()));
  }

  /**
   * The same module with another driver, which has the same parameters.
   *
   * @param className full name of the driver's class
   */
  public ModuleDescription withDriver(String className) {
    return copy(robot, name, className, parameters);
  }

  /** The same module with another driver, and without parameters, which are a driver's own. */
  public ModuleDescription withBareDriver(String className) {
    return copy(robot, name, className, new Parameters(path(), Map.of()));
  }

  /** The same module with another parameter, as if written at that place. */
  public ModuleDescription withParameter(String parameter, String value, SourceLocation at) {
    Map<String, Parameters.Value> values = new TreeMap<>(parameters.all());
    values.put(parameter, new Parameters.Value(value, at));
    return copy(robot, name, driverClass, new Parameters(path(), values));
  }

  private ModuleDescription copy(String on, String called, String driver, Parameters values) {
    return new ModuleDescription(
        on,
        called,
        serverClass,
        proxyClass,
        driver,
        configuration,
        codebase,
        restart,
        values,
        place);
  }

  /** {@code robot/name}, the module's path in messages and listings. */
  public String path() {
    return robot + "/" + name;
  }
}
