package org.dfra.attack.kit;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.dfra.benchmarks.attack.SourceSockets;

/**
 * Computers of an attack: addresses of 127.0.0.0/8 on one computer. They are this process' own, so
 * that tests beside each other do not meet.
 *
 * <p>A socket that is bound to no address connects from 127.0.0.1, whatever address of the loopback
 * it connects to: a robot's own processes appear as 127.0.0.1. None of these is that.
 *
 * @param robot where the robot's services listen
 * @param operator where the operator calls from
 * @param attacker where the attacker calls from
 * @param otherAttacker where a second attacker calls from
 */
public record AttackHosts(String robot, String operator, String attacker, String otherAttacker) {

  /** Networks 127.1.1 to 127.250.250: neither 127.0 nor ends of a range. */
  private static final int NETWORKS = 250;

  /**
   * The addresses. The test reports itself skipped where the system has only 127.0.0.1, as macOS:
   * robot and attacker are the same computer there.
   */
  public static AttackHosts assumed() {
    long pid = ProcessHandle.current().pid();
    String network = "127.%d.%d.".formatted(1 + pid / NETWORKS % NETWORKS, 1 + pid % NETWORKS);
    AttackHosts hosts = new AttackHosts(network + 10, network + 20, network + 66, network + 67);
    assumeTrue(
        hosts.exist(),
        "this system has no loopback addresses besides 127.0.0.1; robot and attacker need two");
    return hosts;
  }

  /** Sockets that connect from the attacker's address. */
  public SourceSockets attackerSockets() {
    return SourceSockets.from(attacker);
  }

  /** Sockets that connect from the operator's address. */
  public SourceSockets operatorSockets() {
    return SourceSockets.from(operator);
  }

  private boolean exist() {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(attacker))) {
      return socket.isBound();
    } catch (IOException e) { // no such address here: the assumption reports it
      return false;
    }
  }
}
