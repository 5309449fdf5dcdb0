package org.dfra.core.lease;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseStatus;
import org.dfra.time.Scheduler.Task;
import org.jspecify.annotations.Nullable;

/** One lease of a {@link LeaseBook}, whose lock guards what changes here. */
final class LeaseEntry {

  final LeaseHandle handle;
  final Holder holder;
  final @Nullable String host;
  final Instant since;
  final long granted; // nanoseconds of the scheduler
  final Runnable whenOver;
  final Runnable whenCancelled;
  long end; // guarded by the book; nothing where there is no expiry
  @Nullable Task expiry; // guarded by the book; null where nobody need renew

  LeaseEntry(
      UUID id,
      Holder holder,
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
    this.whenOver = whenOver;
    this.whenCancelled = whenCancelled;
  }

  /**
   * What listings show of it.
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
