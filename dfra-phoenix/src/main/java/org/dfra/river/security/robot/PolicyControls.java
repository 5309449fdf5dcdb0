package org.dfra.river.security.robot;

import java.io.InvalidObjectException;
import java.rmi.server.ExportException;
import java.time.Duration;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.call.ProcessObject;
import org.dfra.river.call.RobotAuthentication;

/** Exports {@link PolicyControl} under an identity that is known, and finds it there. */
public final class PolicyControls {

  private static final ProcessObject<PolicyControl> CONTROL =
      new ProcessObject<>(
          "b1a5f2a6-3c8e-4f5b-8d59-0c1f6c7b9a43", PolicyControl.class, Duration.ofSeconds(2));

  private final ProcessObject<PolicyControl>.Own control;

  /** For a process of a robot. */
  public PolicyControls(RobotState robot) {
    this.control = CONTROL.own(robot.control());
  }

  /**
   * Exports it at the port of everything else that the process exports at a host. Does nothing the
   * second time.
   *
   * @param host address of this computer, as in its proxies
   */
  public void export(String host) throws ExportException {
    control.export(host);
  }

  /**
   * That of a robot's process, which only the robot answers.
   *
   * @param robot the robot's name
   * @param process where the process exports its modules
   * @throws InvalidObjectException if no robot can have the name
   */
  public static PolicyControl of(String robot, PeerAddress process) throws InvalidObjectException {
    return RobotAuthentication.require(robot, CONTROL.of(process));
  }
}
