package org.dfra.river.discovery;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;
import net.jini.core.lookup.ServiceID;
import org.jspecify.annotations.Nullable;

/**
 * Selects the next announced lookup service to query. Any host may announce anything, at any rate.
 * So the number of candidates and of concurrent queries is limited, a candidate that does not
 * answer is queried at growing intervals, and one that has answered before has priority.
 *
 * <pre>
 *   announced --&gt; waiting --next()--&gt; asked --succeeded()--&gt; held --lost()--&gt; waiting
 *                    ^                  |
 *                    +---- failed() ----+   waits 1, 2, 4 ... 30 s; removed after 5 in a row
 * </pre>
 *
 * <p>An address is held while the search holds the registrar that answered there. Another address
 * announced with the same service ID is queried all the same: the service ID may be a copy.
 *
 * <p>Order: an address that answered before; then one announced from its own IP address, which
 * costs a spoofer an IP address; then the others. Among equals the one with the fewest failures,
 * then the oldest. At most one address of a host is queried at a time. The last of the {@value
 * #PROBES} probes is reserved for addresses that answered before.
 *
 * <p>Thread-safe.
 */
final class DiscoveryCandidates {

  /** Maximum number of addresses that are stored. */
  static final int MAX_CANDIDATES = 256;

  /** Maximum number of addresses of one host. */
  static final int PER_HOST = 4;

  /** Maximum number of concurrent probes. */
  static final int PROBES = 4;

  /** An unknown address is removed after this many failures in a row. */
  static final int FAILURES = 5;

  /** An address that answered before is removed if it fails and was not announced for this long. */
  static final Duration ANNOUNCEMENT_TIMEOUT = Duration.ofMinutes(5);

  static final Duration SHORTEST_WAIT = Duration.ofSeconds(1);
  static final Duration LONGEST_WAIT = Duration.ofSeconds(30);

  /** The address of a lookup service: host and TCP port for unicast discovery. */
  record LookupAddress(String host, int port) {}

  private static final class Candidate {
    final LookupAddress place;
    ServiceID id; // as announced; after its response, as it claims
    @Nullable LocatedRegistrar held; // the registrar that answered, while the search holds it
    boolean isDirect;
    boolean isKnown;
    boolean isAsked;
    int failures;
    long announcedAt;
    long dueAt;

    Candidate(LookupAddress place, ServiceID id, long now) {
      this.place = place;
      this.id = id;
      this.announcedAt = now;
      this.dueAt = now;
    }

    int rank() {
      return isKnown ? 0 : isDirect ? 1 : 2;
    }
  }

  private final LongSupplier nanos;

  @GuardedBy("this")
  private final Map<LookupAddress, Candidate> candidates = new LinkedHashMap<>();

  private final long origin; // times are relative to it, so that they can be compared

  /**
   * @param nanos monotonic time
   */
  DiscoveryCandidates(LongSupplier nanos) {
    this.nanos = nanos;
    this.origin = nanos.getAsLong();
  }

  private long now() {
    return nanos.getAsLong() - origin;
  }

  /**
   * Adds an announced lookup service.
   *
   * @param id the service ID in the announcement
   * @param isDirect whether the announcement came from the address that it names
   */
  synchronized void announced(LookupAddress place, ServiceID id, boolean isDirect) {
    long now = now();
    Candidate candidate = candidates.get(place);
    if (candidate == null) {
      candidate = new Candidate(place, id, now);
      candidate.isDirect = isDirect;
      if (!makeRoom(candidate)) {
        return;
      }
      candidates.put(place, candidate);
    }
    candidate.announcedAt = now;
    candidate.isDirect |= isDirect;
    if (!candidate.isKnown) {
      candidate.id = id;
    } else if (candidate.failures > 0) { // it is back; a spoofer gains one probe a second
      candidate.dueAt = Math.min(candidate.dueAt, now + SHORTEST_WAIT.toNanos());
    }
  }

  /**
   * Removes another candidate if there are too many; false if the new one has the lowest priority.
   */
  @GuardedBy("this")
  private boolean makeRoom(Candidate wanted) {
    List<Candidate> ofHost = new ArrayList<>();
    for (Candidate each : candidates.values()) {
      if (each.place.host().equals(wanted.place.host())) {
        ofHost.add(each);
      }
    }
    if (ofHost.size() >= PER_HOST) {
      return forgetWorst(ofHost, wanted);
    }
    return candidates.size() < MAX_CANDIDATES
        || forgetWorst(List.copyOf(candidates.values()), wanted);
  }

  @GuardedBy("this")
  private boolean forgetWorst(List<Candidate> of, Candidate wanted) {
    Optional<Candidate> worst =
        of.stream()
            .filter(DiscoveryCandidates::isWaiting)
            .filter(each -> each.rank() >= wanted.rank())
            .max(
                Comparator.comparingInt(Candidate::rank)
                    .thenComparingInt(each -> each.failures)
                    .thenComparing(Comparator.comparingLong(DiscoveryCandidates::age).reversed()));
    worst.ifPresent(each -> candidates.remove(each.place));
    return worst.isPresent();
  }

  private static long age(Candidate candidate) {
    return candidate.announcedAt;
  }

  /**
   * The address to query now, if there is one. The caller then calls {@link #succeeded} or {@link
   * #failed}.
   *
   * @param others running probes of other unknown registrars
   */
  synchronized Optional<LookupAddress> next(int others) {
    long now = now();
    int unknown = others;
    int all = others;
    Set<String> asked = new HashSet<>();
    for (Candidate each : candidates.values()) {
      if (each.isAsked) {
        all++;
        unknown += each.isKnown ? 0 : 1;
        asked.add(each.place.host());
      }
    }
    if (all >= PROBES) {
      return Optional.empty();
    }
    boolean isKnownOnly = unknown >= PROBES - 1;
    Optional<Candidate> next =
        candidates.values().stream()
            .filter(each -> isWaiting(each) && each.dueAt <= now)
            .filter(each -> each.isKnown || !isKnownOnly)
            .filter(each -> !asked.contains(each.place.host()))
            .min(
                Comparator.comparingInt(Candidate::rank)
                    .thenComparingInt(each -> each.failures)
                    .thenComparingLong(DiscoveryCandidates::age));
    next.ifPresent(each -> each.isAsked = true);
    return next.map(each -> each.place);
  }

  /**
   * Whether one more probe of an unknown registrar leaves one for addresses that answered before.
   */
  synchronized boolean isRoomForUnknown(int others) {
    long unknown =
        candidates.values().stream().filter(each -> each.isAsked && !each.isKnown).count();
    return unknown + others < PROBES - 1;
  }

  private static boolean isWaiting(Candidate candidate) {
    return !candidate.isAsked && candidate.held == null;
  }

  /** The time until a waiting address is due, in nanoseconds; empty if none waits. */
  synchronized Optional<Long> untilNext() {
    long now = now();
    @Nullable Long least = null;
    for (Candidate each : candidates.values()) {
      if (isWaiting(each) && each.dueAt > now && (least == null || each.dueAt - now < least)) {
        least = each.dueAt - now;
      }
    }
    return Optional.ofNullable(least);
  }

  /**
   * This lookup service answered at an address. The address is not queried again until it is lost.
   */
  synchronized void succeeded(LookupAddress place, LocatedRegistrar registrar) {
    Candidate candidate = candidates.get(place);
    if (candidate != null) {
      candidate.isAsked = false;
      candidate.isKnown = true;
      candidate.id = registrar.getServiceID();
      candidate.held = registrar;
      candidate.failures = 0;
      candidate.dueAt = now() + SHORTEST_WAIT.toNanos();
    }
  }

  /** An address did not answer, or sent an invalid response. */
  synchronized void failed(LookupAddress place) {
    Candidate candidate = candidates.get(place);
    if (candidate == null) {
      return;
    }
    candidate.isAsked = false;
    candidate.failures++;
    boolean isGone =
        candidate.isKnown
            ? now() - candidate.announcedAt > ANNOUNCEMENT_TIMEOUT.toNanos()
            : candidate.failures >= FAILURES;
    if (isGone) {
      candidates.remove(place);
      return;
    }
    long wait = SHORTEST_WAIT.toNanos() << Math.min(5, candidate.failures - 1);
    candidate.dueAt = now() + Math.min(wait, LONGEST_WAIT.toNanos());
  }

  /**
   * An address could not be queried for lack of a thread. It is queried later; that is no failure.
   */
  synchronized void postponed(LookupAddress place) {
    Candidate candidate = candidates.get(place);
    if (candidate != null) {
      candidate.isAsked = false;
      candidate.dueAt = now() + SHORTEST_WAIT.toNanos();
    }
  }

  /**
   * A lookup service is no longer held: its own address, and those announced with its service ID,
   * are queried again.
   */
  synchronized void lost(LocatedRegistrar registrar) {
    for (Candidate each : candidates.values()) {
      boolean wasHere = registrar.equals(each.held);
      if (wasHere) {
        each.held = null;
      }
      if (wasHere || (each.held == null && each.id.equals(registrar.getServiceID()))) {
        each.failures = 0;
        each.dueAt = now() + SHORTEST_WAIT.toNanos();
      }
    }
  }

  /** Whether the address answered before. */
  synchronized boolean isKnown(LookupAddress place) {
    Candidate candidate = candidates.get(place);
    return candidate != null && candidate.isKnown;
  }

  /** The number of stored addresses. */
  synchronized int size() {
    return candidates.size();
  }
}
