package org.dfra.river.remote;

import java.time.InstantSource;
import java.util.function.LongSupplier;
import net.jini.core.lease.Lease;

/**
 * Whether a lease that has arrived is over, by monotonic time. A lease travels as a span, and River
 * makes a time of the wall clock of it on arrival; from that on the two must not be compared, since
 * somebody may set the clock. So this turns it back into a span at once, and again when the lease
 * was renewed.
 */
final class MonotonicLease {

  private final Lease lease;
  private final InstantSource clock;
  private final LongSupplier nanos;
  private long expiration; // guarded by this; wall time, of the last grant
  private long end; // guarded by this; monotonic

  /**
   * @param lease just granted or arrived
   */
  MonotonicLease(Lease lease) {
    this(lease, InstantSource.system(), System::nanoTime);
  }

  /** For tests: by another time. */
  MonotonicLease(Lease lease, InstantSource clock, LongSupplier nanos) {
    this.lease = lease;
    this.clock = clock;
    this.nanos = nanos;
    take(lease.getExpiration());
  }

  private void take(long granted) {
    expiration = granted;
    double left = 1e6 * ((double) granted - clock.millis()); // for ever is more than a long holds
    end = nanos.getAsLong() + (long) Math.max(0, Math.min(Long.MAX_VALUE / 2.0, left));
  }

  /** Whether it has not run out. */
  synchronized boolean isLive() {
    long granted = lease.getExpiration();
    if (granted != expiration) { // somebody has renewed it
      take(granted);
    }
    return end - nanos.getAsLong() > 0;
  }
}
