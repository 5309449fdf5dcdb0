package org.dfra.river.bootstrap;

import java.util.ArrayList;
import java.util.List;
import org.dfra.core.config.RobotDescription;

/**
 * The lookup services at which a robot's modules register.
 *
 * @param locators lookup services that they join by unicast, {@code jini://host:port} each
 * @param groups discovery groups whose lookup services they join by multicast; none if empty
 */
record LookupSettings(List<String> locators, List<String> groups) {

  /**
   * The settings of a robot. Its own registrar is joined by unicast, so its modules need no
   * multicast for it. A robot on the loopback uses no multicast: other hosts could not reach the
   * announced address.
   *
   * @param host the robot's, resolved
   * @param port TCP port of its own registrar; 0 if that is unknown or there is no registrar
   */
  static LookupSettings of(RobotDescription robot, String host, int port) {
    List<String> locators = new ArrayList<>(robot.locators());
    String own = "jini://" + host + ":" + port;
    if (port != 0 && !locators.contains(own)) {
      locators.add(own);
    }
    return new LookupSettings(
        List.copyOf(locators), HostAddress.isLoopback(host) ? List.of() : robot.lookupGroups());
  }
}
