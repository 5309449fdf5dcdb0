package org.dfra.river.registrar;

import java.net.InetAddress;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.dfra.river.access.AddressRange;

/**
 * Whose registrar it is.
 *
 * @param robot name of the robot, whose modules register from its own computers only; empty for a
 *     registrar that belongs to no robot
 * @param robotHosts the robot's further computers besides the one that the registrar runs on
 */
public record RegistrationPolicy(String robot, List<AddressRange> robotHosts) {

  /** That of a registrar that belongs to no robot. */
  public static final RegistrationPolicy NO_ROBOT = new RegistrationPolicy("", List.of());

  public RegistrationPolicy {
    robotHosts = List.copyOf(robotHosts);
  }

  /**
   * As a Jini configuration has it.
   *
   * @param from addresses and ranges as {@link AddressRange#of} reads them, with commas between
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

  /** What {@link #of} reads as the further computers. */
  public String robotHostsText() {
    return robotHosts.stream().map(AddressRange::toString).collect(Collectors.joining(","));
  }

  /** Whether an address is one of the further computers'. */
  boolean admits(InetAddress address) {
    return robotHosts.stream().anyMatch(each -> each.contains(address));
  }
}
