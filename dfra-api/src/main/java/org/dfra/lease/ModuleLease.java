package org.dfra.lease;

import java.time.Instant;

/**
 * The right to count as a module's client. It renews itself until it is closed; when its holder
 * dies it expires, and the module knows.
 */
public interface ModuleLease extends AutoCloseable {

  /** When it ends unless it is renewed before. */
  Instant expiration();

  /** Whether the module still counts its holder, as far as is known here. */
  boolean isLive();

  /** Gives it back. Idempotent. */
  @Override
  void close();
}
