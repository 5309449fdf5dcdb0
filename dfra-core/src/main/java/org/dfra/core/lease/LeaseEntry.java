package org.dfra.core.lease;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/** One lease of a {@link LeaseRegistry}, whose lock guards its mutable fields. */
final class LeaseEntry {

  final LeaseHandle handle;
  final LeaseRole holder;
  final @Nullable String host;
  final Instant since;
  final long granted; // nanoseconds of the scheduler
  final Runnable onEnd;
  final Runnable onCancel;
  long end; // guarded by the registry; meaningless without an expiry
  int term; // guarded by the registry; counts its grant and its renewals
  @Nullable ScheduledTask expiry; // guarded by the registry; null if no renewal is needed

  LeaseEntry(
      UUID id,
      LeaseRole holder,
      @Nullable String host,
      Instant since,
      long granted,
      Runnable whenOver,
      Runnable whenCancelled) {
    this.handle = LeaseHandle.of(id);
    this.holder = holder;
    this.host = host;
    this.since = since;
    this.granted = granted;
    this.onEnd = whenOver;
    this.onCancel = whenCancelled;
  }

  /**
   * Its status for listings.
   *
   * @param now nanoseconds of the scheduler
   */
  LeaseStatus status(long now) {
    return new LeaseStatus(
        handle,
        holder,
        host,
        since,
        Duration.ofNanos(now - granted),
        expiry == null ? null : Duration.ofNanos(Math.max(0, end - now)));
  }
}
