package org.dfra.core.config;

import java.io.Serializable;
import java.util.List;
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
 * @param download absolute paths of the jars that clients without the module's classes download;
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
    List<String> download,
    boolean restart,
    Parameters parameters,
    Place place)
    implements Serializable {

  public ModuleDescription {
    download = List.copyOf(download);
    DescriptionRules.require(place, DescriptionRules.name("robot", robot));
    DescriptionRules.require(place, DescriptionRules.name("module", name));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "server", serverClass));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "proxy", proxyClass));
    DescriptionRules.require(
        place, DescriptionRules.className("module " + name, "driver", driverClass));
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
      Place place) {
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

  /** {@code robot/name}, the module's path in messages and listings. */
  public String path() {
    return robot + "/" + name;
  }
}
