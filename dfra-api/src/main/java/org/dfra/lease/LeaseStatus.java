package org.dfra.lease;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * A lease as its module sees it.
 *
 * @param handle what administrators name it by; it is no secret, see {@link LeaseHandle}
 * @param role what its holder is
 * @param host address from which it was asked for; null where that is not known, and where the
 *     holder lives in the module's own virtual machine
 * @param grantedAt when it was granted, by the module's clock; for people
 * @param age how long ago that was, by time that nobody sets, as of this answer
 * @param remaining for how long it still lasts unless it is renewed; null where it need not be,
 *     since the holder lives in the module's own virtual machine
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

  /** Whether the holder lives in the module's own virtual machine. */
  public boolean isLocal() {
    return remaining == null;
  }
}
