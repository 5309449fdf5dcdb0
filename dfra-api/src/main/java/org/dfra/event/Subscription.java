package org.dfra.event;

import java.time.Instant;
import java.util.Optional;

/**
 * A listener's subscription to a module. It renews its lease and re-subscribes after a restart of
 * the module automatically. It ends when it is closed or its virtual machine dies.
 */
public interface Subscription extends AutoCloseable {

  /** Events that reached the listener. */
  long received();

  /** Events that the listener did not get: dropped by its policy, or missing in the sequence. */
  long lost();

  /** Since when the module has been unreachable, if it is. */
  Optional<Instant> interruptedSince();

  /**
   * Whether it is active, even if interrupted: it was not closed, no administrator has revoked its
   * lease, and, for a module in this virtual machine, the module has not ended.
   */
  boolean isOpen();

  /** Ends it. Nothing is delivered afterwards, except what is being delivered now. */
  @Override
  void close();
}
