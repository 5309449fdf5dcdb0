package org.dfra.core.config;

import java.io.Serializable;
import java.util.List;

/**
 * The robot's own lookup service (reggie), as the robot's XML describes it.
 *
 * @param port TCP port at which unicast discovery finds it, 0 to 65535; 0 lets the system choose,
 *     so that only multicast finds it
 * @param classes TCP port of the class server beside it, 1 to 65535; {@link #NO_CLASSES} for none
 * @param restart whether it is started again at once after a crash, rather than at the next call
 * @param from addresses, ranges as {@code 10.0.0.0/24}, and host names of the robot's further
 *     computers, whose registrations of the robot's modules it takes; they are not resolved here;
 *     empty for its own computer only
 * @param place where it was written
 */
public record RegistrarDescription(
    int port, int classes, boolean restart, List<String> from, Place place)
    implements Serializable {

  /** The port that unicast discovery uses where none is named. */
  public static final int DISCOVERY_PORT = 4160;

  /** The port of a robot's class server where none is named. */
  public static final int CLASS_PORT = 8085;

  /** In place of a port: the robot runs no class server. */
  public static final int NO_CLASSES = 0;

  /** How XML writes {@link #NO_CLASSES}. */
  static final String OFF = "off";

  public RegistrarDescription {
    Rules.require(place, Rules.registrarPort(Integer.toString(port)));
    Rules.require(place, classes == NO_CLASSES ? null : Rules.classPort(Integer.toString(classes)));
    from = List.copyOf(from);
    for (String each : from) {
      Rules.require(place, Rules.moduleHost(each));
    }
  }

  /** That of a robot whose modules all run on the registrar's computer. */
  public RegistrarDescription(int port, int classes, boolean restart, Place place) {
    this(port, classes, restart, List.of(), place);
  }

  /** Whether the robot runs a class server. */
  public boolean servesClasses() {
    return classes != NO_CLASSES;
  }
}
