package org.dfra.core.config;

import java.io.Serializable;
import java.util.List;

/**
 * The robot's own lookup service (reggie), as the robot's XML describes it.
 *
 * @param port TCP port for unicast discovery, 0 to 65535; 0 lets the system choose, so that only
 *     multicast finds it
 * @param classServerPort TCP port of the class server beside it, 1 to 65535; {@link
 *     #NO_CLASS_SERVER} for none
 * @param restart whether it is restarted at once after a crash, rather than at the next call
 * @param moduleHosts addresses, ranges as {@code 10.0.0.0/24}, and host names of the robot's
 *     further computers, whose registrations of the robot's modules it accepts; they are not
 *     resolved here; empty for its own computer only
 * @param place its place in the configuration
 */
public record RegistrarDescription(
    int port, int classServerPort, boolean restart, List<String> moduleHosts, SourceLocation place)
    implements Serializable {

  /** The default port of unicast discovery. */
  public static final int DEFAULT_PORT = 4160;

  /** The default port of a robot's class server. */
  public static final int DEFAULT_CLASS_SERVER_PORT = 8085;

  /** In place of a port: the robot runs no class server. */
  public static final int NO_CLASS_SERVER = 0;

  /** How XML writes {@link #NO_CLASS_SERVER}. */
  static final String OFF = "off";

  public RegistrarDescription {
    DescriptionRules.require(place, DescriptionRules.registrarPort(Integer.toString(port)));
    DescriptionRules.require(
        place,
        classServerPort == NO_CLASS_SERVER
            ? null
            : DescriptionRules.classServerPort(Integer.toString(classServerPort)));
    moduleHosts = List.copyOf(moduleHosts);
    for (String each : moduleHosts) {
      DescriptionRules.require(place, DescriptionRules.moduleHost(each));
    }
  }

  /** The registrar of a robot whose modules all run on the registrar's computer. */
  public RegistrarDescription(
      int port, int classServerPort, boolean restart, SourceLocation place) {
    this(port, classServerPort, restart, List.of(), place);
  }

  /** Whether the robot runs a class server. */
  public boolean hasClassServer() {
    return classServerPort != NO_CLASS_SERVER;
  }
}
