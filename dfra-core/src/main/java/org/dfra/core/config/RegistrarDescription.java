package org.dfra.core.config;

import java.io.Serializable;

/**
 * The robot's own lookup service (reggie), as the robot's XML describes it.
 *
 * @param port TCP port at which unicast discovery finds it, 0 to 65535; 0 lets the system choose,
 *     so that only multicast finds it
 * @param restart whether it is started again at once after a crash, rather than at the next call
 * @param place where it was written
 */
public record RegistrarDescription(int port, boolean restart, Place place) implements Serializable {

  /** The port that unicast discovery uses where none is named. */
  public static final int DISCOVERY_PORT = 4160;

  public RegistrarDescription {
    Rules.require(place, Rules.registrarPort(Integer.toString(port)));
  }
}
