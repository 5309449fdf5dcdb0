package org.dfra.cli.doctor;

import java.net.Inet4Address;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RobotDescription;
import org.dfra.river.access.AddressRange;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.security.SecureProcess;

/**
 * Checks which robots of this computer can be reached from the network, and which hosts may
 * administer them: where this computer has joined no team, every program on such a robot's network
 * can read it, command it and stop it.
 */
final class ExposureCheck implements Check {

  private static final String DOCUMENT = "docs/concepts/security.md";

  /** A shorter prefix of an IPv4 range is of more than one organization, such as 10.0.0.0/8. */
  private static final int IPV4_ORGANIZATION = 8;

  /** The same of an IPv6 range. */
  private static final int IPV6_ORGANIZATION = 16;

  private final List<RobotDescription> robots;
  private final UnaryOperator<String> addresses;
  private final boolean isTeamOnly;

  /**
   * @param robots the robots of this computer
   * @param addresses resolves a host of a description to its address; throws a {@link
   *     ConfigurationException} if there is none
   */
  ExposureCheck(List<RobotDescription> robots, UnaryOperator<String> addresses) {
    this(robots, addresses, false);
  }

  private ExposureCheck(
      List<RobotDescription> robots, UnaryOperator<String> addresses, boolean isTeamOnly) {
    this.isTeamOnly = isTeamOnly;
    this.robots = List.copyOf(robots);
    this.addresses = addresses;
  }

  /** The check for robots that are known on this computer. */
  static ExposureCheck of(List<RobotDescription> robots) {
    return new ExposureCheck(
        robots, HostAddress::resolve, SecureProcess.current().mode() != SecurityMode.OPEN);
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
          .filter(ExposureCheck::isEverybody)
          .forEach(range -> findings.add(administrators(robot.name(), range)));
      robot.registrar().stream()
          .flatMap(registrar -> registrar.moduleHosts().stream())
          .filter(ExposureCheck::isEverybody)
          .forEach(range -> findings.add(registrants(robot.name(), range)));
    }
    return findings;
  }

  private Finding reach(String robot, String address) {
    if (isTeamOnly) {
      return Finding.ok(
          subject(), robot + " is at " + address + ", and answers members of its team only");
    }
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

  /**
   * Whether a range has so many addresses that most of them are strangers'.
   *
   * @param from an address, a range or a host name, which is one computer's
   */
  private static boolean isEverybody(String from) {
    if (from.indexOf('/') < 0) {
      return false;
    }
    AddressRange range = AddressRange.of(from);
    return range.prefix()
        < (range.network() instanceof Inet4Address ? IPV4_ORGANIZATION : IPV6_ORGANIZATION);
  }

  private Finding administrators(String robot, String range) {
    return Finding.warn(
        subject(),
        robot + " may be administered from " + range + ", which counts as everywhere",
        "Name the operators' addresses in <administration from=\"…\"> of its XML; "
            + DOCUMENT
            + " says what administrators can do.");
  }

  private Finding registrants(String robot, String range) {
    return Finding.warn(
        subject(),
        "the registrar of "
            + robot
            + " takes modules of this robot from "
            + range
            + ", which counts as everywhere",
        "Name the addresses of the robot's further computers in <registrar module-hosts=\"…\"> of its XML; "
            + DOCUMENT
            + " says what others could register.");
  }
}
