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
 * @param holder what its holder is
 * @param host address from which it was asked for; null where that is not known, and where the
 *     holder lives in the module's own virtual machine
 * @param since when it was granted, by the module's clock; for people
 * @param held how long ago that was, by time that nobody sets, as of this answer
 * @param remaining for how long it still lasts unless it is renewed; null where it need not be,
 *     since the holder lives in the module's own virtual machine
 */
public record LeaseStatus(
    LeaseHandle handle,
    Holder holder,
    @Nullable String host,
    Instant since,
    Duration held,
    @Nullable Duration remaining)
    implements Serializable {

  public LeaseStatus {
    Objects.requireNonNull(handle, "handle");
    Objects.requireNonNull(holder, "holder");
    Objects.requireNonNull(since, "since");
    Objects.requireNonNull(held, "held");
  }

  /** Whether the holder lives in the module's own virtual machine. */
  public boolean isLocal() {
    return remaining == null;
  }
}
