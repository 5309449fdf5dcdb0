package org.dfra.app.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.bootstrap.HostAddress;

/**
 * Checks which robots of this computer can be reached from the network, and which hosts may
 * administer them: calls are not authenticated yet, so every program on such a robot's network can
 * read it, command it and stop it.
 */
final class ExposureCheck implements Check {

  private static final String DOCUMENT = "docs/concepts/security.md";

  private final List<RobotDescription> robots;
  private final UnaryOperator<String> addresses;

  /**
   * @param robots the robots of this computer
   * @param addresses resolves a host of a description to its address; throws a {@link
   *     ConfigurationException} if there is none
   */
  ExposureCheck(List<RobotDescription> robots, UnaryOperator<String> addresses) {
    this.robots = List.copyOf(robots);
    this.addresses = addresses;
  }

  /** The check for robots that are known on this computer. */
  static ExposureCheck of(List<RobotDescription> robots) {
    return new ExposureCheck(robots, HostAddress::resolve);
  }

  @Override
  public Subject subject() {
    return Subject.EXPOSURE;
  }

  @Override
  public List<Finding> run() {
    List<Finding> findings = new ArrayList<>();
    for (RobotDescription robot : robots) {
      String address;
      try {
        address = addresses.apply(robot.host());
      } catch (ConfigurationException e) {
        findings.add(
            Finding.fail(
                subject(), e, "Name an address of this computer as host in the robot's XML."));
        continue;
      }
      findings.add(reach(robot.name(), address));
      robot.administration().administratorHosts().stream()
          .filter(range -> range.endsWith("/0"))
          .forEach(range -> findings.add(everybody(robot.name(), range)));
    }
    return findings;
  }

  private Finding reach(String robot, String address) {
    return HostAddress.isLoopback(address)
        ? Finding.ok(subject(), robot + " is at " + address + ", which only this computer reaches")
        : Finding.warn(
            subject(),
            robot
                + " is at "
                + address
                + ", and every program that reaches this address can read and command it",
            "Let only computers that you trust reach this address; "
                + DOCUMENT
                + " says what strangers can do.");
  }

  private Finding everybody(String robot, String range) {
    return Finding.warn(
        subject(),
        robot + " may be administered from " + range + ", so from everywhere",
        "Name the operators' addresses in <administration from=\"…\"> of its XML; "
            + DOCUMENT
            + " says what administrators can do.");
  }
}
