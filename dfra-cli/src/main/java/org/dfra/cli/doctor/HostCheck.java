package org.dfra.cli.doctor;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.List;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.config.ConfigurationException;
import org.dfra.river.bootstrap.HostAddress;

/** Checks what this computer's own name resolves to, and which address proxies contain. */
final class HostCheck implements Check {

  /** Resolves names. */
  interface HostResolver {
    /** This computer's address, by its own name. */
    InetAddress ownName() throws UnknownHostException;

    /** The address that proxies contain for this setting. */
    String advertisedAddress(String wanted);
  }

  private final HostResolver names;
  private final String wanted;

  /**
   * @param wanted configured address or name, or {@code auto}
   */
  HostCheck(HostResolver names, String wanted) {
    this.names = names;
    this.wanted = wanted;
  }

  /** The check for this computer. */
  static HostCheck ofThisComputer(String wanted) {
    return new HostCheck(
        new HostResolver() {
          @Override
          public InetAddress ownName() throws UnknownHostException {
            return InetAddress.getLocalHost();
          }

          @Override
          public String advertisedAddress(String host) {
            return HostAddress.resolve(host);
          }
        },
        wanted);
  }

  @Override
  public Subject subject() {
    return Subject.HOST_ADDRESS;
  }

  @Override
  public List<Finding> run() {
    String chosen;
    try {
      chosen = names.advertisedAddress(wanted);
    } catch (ConfigurationException e) {
      return List.of(
          Finding.fail(subject(), e, "Name an address of this computer in DFRA_HOST, or auto."));
    }
    return List.of(name(chosen), address(chosen));
  }

  private Finding name(String chosen) {
    InetAddress own;
    try {
      own = names.ownName();
    } catch (UnknownHostException e) {
      return Finding.warn(
          Subject.HOST_NAME,
          "this computer's own name resolves to no address",
          "Add a line to /etc/hosts with its address and its name.");
    }
    String what = own.getHostName() + " resolves to " + own.getHostAddress();
    if (!own.isLoopbackAddress() || HostAddress.isLoopback(chosen)) {
      return Finding.ok(Subject.HOST_NAME, what);
    }
    return Finding.warn(
        Subject.HOST_NAME,
        what + ", which no other computer reaches; DFRA uses " + chosen + " instead",
        "Never name "
            + own.getHostName()
            + " as a robot's host, or let /etc/hosts give it "
            + chosen
            + ".");
  }

  private Finding address(String chosen) {
    return HostAddress.isLoopback(chosen)
        ? Finding.warn(
            subject(),
            "proxies carry " + chosen + ", which only this computer reaches",
            "Connect a network, or name the address that others reach in DFRA_HOST;"
                + " nothing is to be done where all robots are simulated here.")
        : Finding.ok(subject(), "proxies carry " + chosen);
  }
}
