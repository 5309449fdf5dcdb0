package org.dfra.core.module;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.UUID;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.lease.ModuleLease;

/**
 * The lease of a client in the module's own virtual machine. Both end together, so no renewal is
 * needed: it is valid until it is closed or the module ends.
 */
final class LocalLease implements ModuleLease {

  private final LeaseRegistry book;
  private final UUID id;
  private final Duration duration;
  private final InstantSource clock;

  LocalLease(LeaseRegistry book, UUID id, Duration duration, InstantSource clock) {
    this.book = book;
    this.id = id;
    this.duration = duration;
    this.clock = clock;
  }

  @Override
  public Instant expiration() {
    return clock.instant().plus(duration);
  }

  @Override
  public boolean isLive() {
    return book.contains(id);
  }

  @Override
  public void close() {
    boolean unused = book.cancel(id);
  }
}
