package org.dfra.core.policy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import org.dfra.core.policy.Obligations.RateLimit;
import org.dfra.security.AccessRequest;

/**
 * Counts the calls that a rule permits to each caller: a member by its role and name, a stranger by
 * its address. In no period of the limit's length are more calls permitted than the limit. Refused
 * calls do not count.
 *
 * <p>The memory is bounded: beyond {@value #MAX_CALLERS} callers within a period, all further ones
 * share one count.
 */
final class CallRateLimiter {

  static final int MAX_CALLERS = 256;

  private final RateLimit limit;
  private final LongSupplier nanos;
  private final ConcurrentHashMap<String, SlidingWindow> windows = new ConcurrentHashMap<>();
  private final SlidingWindow shared;

  /**
   * @param nanos a monotonic clock in nanoseconds
   */
  CallRateLimiter(RateLimit limit, LongSupplier nanos) {
    this.limit = limit;
    this.nanos = nanos;
    this.shared = new SlidingWindow(limit);
  }

  /** Counts a call. Returns false, and counts nothing, if it is one too many. */
  boolean tryCall(AccessRequest request) {
    return window(principal(request)).tryCall(nanos.getAsLong());
  }

  /** What distinguishes callers: a role and a name have no colon before the first one. */
  static String principal(AccessRequest request) {
    return request
        .caller()
        .member()
        .map(member -> member.role().text() + ":" + member.name())
        .orElseGet(() -> "stranger:" + request.caller().address());
  }

  private SlidingWindow window(String principal) {
    SlidingWindow known = windows.get(principal);
    if (known != null) {
      return known;
    }
    if (windows.size() >= MAX_CALLERS) {
      long now = nanos.getAsLong();
      windows.values().removeIf(each -> each.isIdle(now));
      if (windows.size() >= MAX_CALLERS) {
        return shared;
      }
    }
    return windows.computeIfAbsent(principal, unused -> new SlidingWindow(limit));
  }

  /** The times of a caller's last calls, as many as the limit allows in a period. */
  private static final class SlidingWindow {

    private final long period;

    @GuardedBy("this")
    private final long[] times;

    @GuardedBy("this")
    private int count;

    @GuardedBy("this")
    private int oldest;

    SlidingWindow(RateLimit limit) {
      this.period = limit.per().toNanos();
      this.times = new long[limit.max()];
    }

    synchronized boolean tryCall(long now) {
      if (count < times.length) {
        times[count++] = now;
        return true;
      }
      if (now - times[oldest] < period) {
        return false;
      }
      times[oldest] = now;
      oldest = (oldest + 1) % times.length;
      return true;
    }

    /** Whether its calls no longer count. */
    synchronized boolean isIdle(long now) {
      int newest = count < times.length ? count - 1 : (oldest + count - 1) % count;
      return newest < 0 || now - times[newest] >= period;
    }
  }
}
