package org.dfra.event;

import java.time.Instant;
import java.util.Optional;

/**
 * A listener's tie to a module. It renews its lease by itself, comes back by itself when the module
 * was dead, and ends when it is closed or its virtual machine dies.
 */
public interface Subscription extends AutoCloseable {

  /** Events that reached the listener. */
  long received();

  /** Events that the listener did not get: dropped by its policy, or missing in the sequence. */
  long lost();

  /** Since when the module has not been reached, while that is so. */
  Optional<Instant> interruptedSince();

  /**
   * Whether it goes on, be it interrupted or not: it was not closed, no administrator has revoked
   * its lease, and the module in this virtual machine has not ended.
   */
  boolean isOpen();

  /** Ends it. Nothing is delivered afterwards, except what is being delivered now. */
  @Override
  void close();
}
