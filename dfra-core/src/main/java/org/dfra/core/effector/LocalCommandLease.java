package org.dfra.core.effector;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.UUID;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;

/**
 * The lease of a commander in the effector's own virtual machine: it is valid until it is closed or
 * revoked, or the module ends.
 */
record LocalCommandLease(
    LeaseRegistry registry, UUID id, CommandKey key, Duration duration, InstantSource clock)
    implements CommandLease {

  @Override
  public Instant expiration() {
    return clock.instant().plus(duration);
  }

  @Override
  public boolean isLive() {
    return registry.contains(id);
  }

  @Override
  public void close() {
    boolean unused = registry.cancel(id);
  }
}
