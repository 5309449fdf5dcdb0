package org.dfra.river.remote;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.InstantSource;
import java.util.function.LongSupplier;
import net.jini.core.lease.Lease;

/**
 * Determines by monotonic time whether a received lease has expired. A lease is sent as a duration,
 * and River converts it to wall time on arrival. Later the two must not be compared, since the
 * clock may be set. So this converts it back to a duration at once, and again after each renewal.
 */
final class MonotonicLease {

  private final Lease lease;
  private final InstantSource clock;
  private final LongSupplier nanos;

  // wall time, of the last grant
  @GuardedBy("this")
  private long expiration;

  // monotonic
  @GuardedBy("this")
  private long end;

  /**
   * @param lease just granted or received
   */
  MonotonicLease(Lease lease) {
    this(lease, InstantSource.system(), System::nanoTime);
  }

  /** For tests, with another clock. */
  MonotonicLease(Lease lease, InstantSource clock, LongSupplier nanos) {
    this.lease = lease;
    this.clock = clock;
    this.nanos = nanos;
    take(lease.getExpiration());
  }

  @GuardedBy("this")
  private void take(long granted) {
    expiration = granted;
    double left = 1e6 * ((double) granted - clock.millis()); // FOREVER exceeds a long
    end = nanos.getAsLong() + (long) Math.max(0, Math.min(Long.MAX_VALUE / 2.0, left));
  }

  /** Whether it has not expired. */
  synchronized boolean isLive() {
    long granted = lease.getExpiration();
    if (granted != expiration) { // it was renewed
      take(granted);
    }
    return end - nanos.getAsLong() > 0;
  }
}
