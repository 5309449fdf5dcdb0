package org.dfra.river.registrar;

import java.net.InetAddress;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.river.access.AddressRange;

/**
 * The owner of a registrar.
 *
 * @param robot name of the robot, whose modules register from its hosts only; empty for a registrar
 *     that belongs to no robot
 * @param robotHosts the robot's additional hosts besides the one that the registrar runs on
 */
public record RegistrationPolicy(String robot, List<AddressRange> robotHosts) {

  /** The policy of a registrar that belongs to no robot. */
  public static final RegistrationPolicy NO_ROBOT = new RegistrationPolicy("", List.of());

  public RegistrationPolicy {
    robotHosts = List.copyOf(robotHosts);
  }

  /**
   * Parses the policy in a Jini configuration.
   *
   * @param from addresses and ranges as {@link AddressRange#of} reads them, separated by commas
   * @throws IllegalArgumentException if one is neither
   */
  public static RegistrationPolicy of(String robot, String from) {
    return new RegistrationPolicy(
        robot,
        Arrays.stream(from.split(","))
            .map(String::strip)
            .filter(each -> !each.isEmpty())
            .map(AddressRange::of)
            .toList());
  }

  /** The additional hosts in the format of {@link #of}. */
  public String robotHostsText() {
    return robotHosts.stream().map(AddressRange::toString).collect(Collectors.joining(","));
  }

  /** Whether an address belongs to an additional host. */
  boolean admits(InetAddress address) {
    return robotHosts.stream().anyMatch(each -> each.contains(address));
  }
}
