package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.cli.doctor.CheckRunner.Check;

/** Checks whether the ports that a robot needs are free, or used by DFRA itself. */
final class PortCheck implements Check {

  /**
   * The process that listens on a port.
   *
   * @param pid process ID, or −1 if unknown, for example for other users' processes
   * @param command its command line; empty if unknown
   * @param isDfra whether it is a process of DFRA
   */
  record PortUser(long pid, String command, boolean isDfra) {}

  /** Finds the processes that listen on ports. */
  interface PortProbe {
    /** The process that listens on a TCP port of this computer; empty if the port is free. */
    Optional<PortUser> user(int port);
  }

  private final PortProbe ports;
  private final Map<Integer, String> uses;

  /**
   * @param uses the purpose of each port
   */
  PortCheck(PortProbe ports, Map<Integer, String> uses) {
    this.ports = ports;
    this.uses = uses;
  }

  @Override
  public Subject subject() {
    return Subject.PORT;
  }

  @Override
  public List<Finding> run() {
    List<Finding> findings = new ArrayList<>();
    uses.forEach((port, use) -> findings.add(at(port, use)));
    return findings;
  }

  private Finding at(int port, String use) {
    String what = port + ", for " + use + ", is ";
    Optional<PortUser> holder = ports.user(port);
    if (holder.isEmpty()) {
      return Finding.ok(subject(), what + "free");
    }
    PortUser by = holder.get();
    if (by.isDfra()) {
      return Finding.ok(subject(), what + "held by DFRA, process " + by.pid());
    }
    String process =
        by.pid() < 0 ? "a process of another user" : "process " + by.pid() + ", " + by.command();
    return Finding.warn(
        subject(),
        what + "held by " + process,
        by.pid() < 0
            ? "As root, ss -ltnp shows it; end it if it is not needed, or give "
                + use
                + " another port."
            : "End it if it is not needed, or give " + use + " another port.");
  }
}
