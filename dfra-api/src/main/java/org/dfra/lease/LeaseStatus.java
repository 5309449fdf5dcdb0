package org.dfra.lease;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A lease as its module reports it.
 *
 * @param handle its public name for administrators; not secret, see {@link LeaseHandle}
 * @param role the role of its holder
 * @param host address of the client that requested it; null if unknown, and if the holder runs in
 *     the module's own virtual machine
 * @param grantedAt when it was granted, by the module's clock; for display
 * @param age time since then by a monotonic clock, as of this answer
 * @param remaining time until it expires unless renewed; null if it does not expire, since the
 *     holder runs in the module's own virtual machine
 */
public record LeaseStatus(
    LeaseHandle handle,
    LeaseRole role,
    @Nullable String host,
    Instant grantedAt,
    Duration age,
    @Nullable Duration remaining)
    implements Serializable {

  public LeaseStatus {
    Objects.requireNonNull(handle, "handle");
    Objects.requireNonNull(role, "role");
    Objects.requireNonNull(grantedAt, "grantedAt");
    Objects.requireNonNull(age, "age");
  }

  /** Whether the holder runs in the module's own virtual machine. */
  public boolean isLocal() {
    return remaining == null;
  }
}
