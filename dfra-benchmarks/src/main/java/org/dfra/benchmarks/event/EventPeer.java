package org.dfra.benchmarks.event;

import java.util.Locale;
import java.util.function.Supplier;

/** What is compared: ways to tell processes of this computer of events. */
public enum EventPeer {

  /** The least that such a program can do. */
  TCP(
      "a bare TCP program: a thread for each listener writes a message of as many bytes and awaits"
          + " an acknowledgement; no objects, no queues that drop, no deadlines, no leases",
      TcpEvents::new),

  /** DFRA as robots and their clients use it. */
  DFRA(
      "events of a module, as robots send them: each is a call with a deadline, whose bytes are"
          + " checked and filtered",
      ModuleEvents::new);

  /** The one that the other is compared with. */
  public static final EventPeer REFERENCE = TCP;

  private final String description;
  private final Supplier<EventTransport> transport;

  EventPeer(String description, Supplier<EventTransport> transport) {
    this.description = description;
    this.transport = transport;
  }

  /** Its name in tables and records. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What it is, without a full stop. */
  public String description() {
    return description;
  }

  /** For one process, the source's or a listener's. */
  EventTransport transport() {
    return transport.get();
  }
}
