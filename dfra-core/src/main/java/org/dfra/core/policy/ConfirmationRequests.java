package org.dfra.core.policy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import org.dfra.security.AccessRequest;
import org.jspecify.annotations.Nullable;

/**
 * The calls that wait for an operator's confirmation. A call is confirmed for a time, for its
 * caller, its method, its object and the rule. Thread-safe.
 *
 * <p>The memory is bounded: at most {@value #MAX_REQUESTS} requests are kept, and {@value
 * #MAX_OF_CALLER} of one caller. Requests that nobody confirms are dropped after {@value
 * #KEPT_SECONDS} s.
 */
public final class ConfirmationRequests implements Confirmations {

  /** The most requests. */
  public static final int MAX_REQUESTS = 64;

  /** The most requests of one caller. */
  public static final int MAX_OF_CALLER = 4;

  /** How long a request is kept, in seconds. */
  public static final int KEPT_SECONDS = 300;

  private final LongSupplier nanos;

  @GuardedBy("this")
  private final Map<CallKey, Entry> entries = new LinkedHashMap<>();

  @GuardedBy("this")
  private long lastNumber;

  /** The calls that one confirmation is about. */
  private record CallKey(
      String principal, String rule, String robot, String object, String method) {}

  private static final class Entry {
    final long number;
    final AccessRequest request;
    long end; // of the wait, or of the confirmation
    boolean isConfirmed;

    Entry(long number, AccessRequest request, long end) {
      this.number = number;
      this.request = request;
      this.end = end;
    }
  }

  /**
   * A request that waits.
   *
   * @param number by which an operator confirms it
   */
  public record PendingConfirmation(long number, AccessRequest request) {}

  /**
   * @param nanos a monotonic clock in nanoseconds
   */
  public ConfirmationRequests(LongSupplier nanos) {
    this.nanos = nanos;
  }

  @Override
  public synchronized boolean isConfirmed(AccessRequest request, PolicyRule rule) {
    dropEnded();
    String principal = CallRateLimiter.principal(request);
    CallKey key =
        new CallKey(
            principal, rule.name(), request.robot(), request.object(), request.methodName());
    @Nullable Entry known = entries.get(key);
    if (known != null) {
      return known.isConfirmed;
    }
    long ofCaller =
        entries.keySet().stream().filter(each -> each.principal().equals(principal)).count();
    if (entries.size() < MAX_REQUESTS && ofCaller < MAX_OF_CALLER) {
      long end = nanos.getAsLong() + Duration.ofSeconds(KEPT_SECONDS).toNanos();
      entries.put(key, new Entry(++lastNumber, request, end));
    }
    return false;
  }

  @GuardedBy("this")
  private void dropEnded() {
    long now = nanos.getAsLong();
    entries.values().removeIf(each -> now - each.end >= 0);
  }

  /** The requests that wait, the oldest first. */
  public synchronized List<PendingConfirmation> pending() {
    dropEnded();
    List<PendingConfirmation> pending = new ArrayList<>();
    entries.values().stream()
        .filter(each -> !each.isConfirmed)
        .forEach(each -> pending.add(new PendingConfirmation(each.number, each.request)));
    return pending;
  }

  /**
   * Confirms a request: such calls are permitted from now on.
   *
   * @param duration for how long
   * @return false if there is no such request any more
   */
  public synchronized boolean confirm(long number, Duration duration) {
    dropEnded();
    for (Entry each : entries.values()) {
      if (each.number == number && !each.isConfirmed) {
        each.isConfirmed = true;
        each.end = nanos.getAsLong() + duration.toNanos();
        return true;
      }
    }
    return false;
  }
}
