package org.dfra.cli.robot;

import java.io.IOException;
import java.net.InetAddress;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.host.CommandName;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.security.SecureProcess;

/** Whether a robot may be brought up with the identity of this computer, or without one. */
final class RobotSecurity {

  private RobotSecurity() {}

  /**
   * Checks it, before anything is started.
   *
   * @param mayBeOpen whether a robot without an identity may have an address that others reach
   * @throws ConfigurationException if it must not be brought up; the message says what to do
   * @throws IOException if its host is unknown
   */
  static void require(RobotDescription robot, boolean mayBeOpen) throws IOException {
    SecureProcess.Installed own = SecureProcess.current();
    if (own.mode() == SecurityMode.OPEN) {
      requireLoopback(robot, mayBeOpen);
    } else if (!own.robot().equals(robot.name())) {
      throw new ConfigurationException(
          robot.source()
              + ": robot "
              + robot.name()
              + " cannot be brought up by "
              + own.name()
              + ", which this computer is; join the team with the bundle of this robot: "
              + CommandName.current()
              + " security join "
              + robot.name()
              + ".bundle");
    }
  }

  private static void requireLoopback(RobotDescription robot, boolean mayBeOpen)
      throws IOException {
    String host = HostAddress.resolve(robot.host());
    if (!mayBeOpen && !InetAddress.getByName(host).isLoopbackAddress()) {
      throw new ConfigurationException(
          robot.source()
              + ": robot "
              + robot.name()
              + " would be open to everybody who reaches "
              + host
              + ", since this computer has joined no team; join one ("
              + CommandName.current()
              + " security join NAME.bundle), or allow it with --open");
    }
  }
}
