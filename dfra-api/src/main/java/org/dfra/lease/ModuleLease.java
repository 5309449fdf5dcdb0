package org.dfra.lease;

import java.time.Instant;

/**
 * The right to count as a module's client. It renews itself until it is closed. When its holder
 * dies it expires, and the module drops the client.
 */
public interface ModuleLease extends AutoCloseable {

  /** When it expires unless renewed before. */
  Instant expiration();

  /** Whether the module still counts its holder as a client, as far as the holder knows. */
  boolean isLive();

  /** Releases the lease. Idempotent. */
  @Override
  void close();
}
