package org.dfra.cli.doctor;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dfra.cli.doctor.CheckRunner.Check;

/**
 * Checks whether lookup services can be discovered by group: whether multicast datagrams are
 * received.
 */
final class MulticastCheck implements Check {

  /** How long the check waits for its own datagram. */
  static final Duration PATIENCE = Duration.ofMillis(500);

  /** The multicast capability of the computer's network. */
  interface Network {
    /** Names of the interfaces that are up, not the loopback and capable of multicast. */
    List<String> interfaces() throws IOException;

    /**
     * Sends a request for a group that does not exist, and waits to receive it.
     *
     * @return the round-trip time, or empty if it was not received
     */
    Optional<Duration> roundTrip(String networkInterface) throws IOException;
  }

  private final Network network;
  private final List<String> groups;

  /**
   * @param groups the requested discovery groups; none if empty
   */
  MulticastCheck(Network network, List<String> groups) {
    this.network = network;
    this.groups = groups;
  }

  @Override
  public Subject subject() {
    return Subject.MULTICAST;
  }

  @Override
  public List<Finding> run() {
    if (groups.isEmpty()) {
      return List.of(Finding.ok(subject(), "no group is asked for, so it is not needed"));
    }
    List<String> interfaces;
    try {
      interfaces = network.interfaces();
    } catch (IOException e) {
      return List.of(
          Finding.fail(
              subject(),
              "the network interfaces cannot be listed (" + e.getMessage() + ")",
              "Ask this computer's administrator why."));
    }
    if (interfaces.isEmpty()) {
      return List.of(
          Finding.warn(
              subject(),
              "no network interface but the loopback can multicast, so no robot is found by group",
              "Connect a network, or name the team's registrars in DFRA_LOCATORS."));
    }
    return interfaces.stream().map(this::at).toList();
  }

  private Finding at(String networkInterface) {
    try {
      return network
          .roundTrip(networkInterface)
          .map(
              took ->
                  Finding.ok(
                      subject(),
                      "a request on "
                          + networkInterface
                          + " was received after "
                          + DurationText.of(took)))
          .orElseGet(
              () ->
                  Finding.fail(
                      subject(),
                      "a request on "
                          + networkInterface
                          + " was sent and not received within "
                          + DurationText.of(PATIENCE),
                      "Let a firewall pass UDP port 4160 to and from 224.0.1.84 and 224.0.1.85, or"
                          + " name the team's registrars in DFRA_LOCATORS."));
    } catch (IOException e) {
      return Finding.fail(
          subject(),
          "nothing can be sent on " + networkInterface + " (" + e.getMessage() + ")",
          "Give it a route for 224.0.0.0/4, or name the team's registrars in DFRA_LOCATORS.");
    }
  }
}
