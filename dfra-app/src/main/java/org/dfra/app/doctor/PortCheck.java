package org.dfra.app.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Whether the ports that a robot needs are free, or held by DFRA itself. */
final class PortCheck implements Check {

  /**
   * Who listens on a port.
   *
   * @param pid process number, or −1 where the system does not tell, as of other users' processes
   * @param command what it runs; empty where that is not told
   * @param isDfra whether it is a process of DFRA
   */
  record PortUser(long pid, String command, boolean isDfra) {}

  /** Who listens where. */
  interface PortProbe {
    /** Who listens on a TCP port of this computer; empty if nobody does. */
    Optional<PortUser> user(int port);
  }

  private final PortProbe ports;
  private final Map<Integer, String> uses;

  /**
   * @param uses what each port is for
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
    String who =
        by.pid() < 0 ? "a process of another user" : "process " + by.pid() + ", " + by.command();
    return Finding.warn(
        subject(),
        what + "held by " + who,
        by.pid() < 0
            ? "As root, ss -ltnp tells which; end it if it is not needed, or give "
                + use
                + " another port."
            : "End it if it is not needed, or give " + use + " another port.");
  }
}
