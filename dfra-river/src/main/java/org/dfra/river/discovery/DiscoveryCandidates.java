package org.dfra.river.discovery;

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
 * Which of the announced lookup services is asked next. Anybody may announce anything, at any rate:
 * so few are remembered, few are asked at once, one that does not answer is asked more and more
 * rarely, and one that once answered goes first.
 *
 * <pre>
 *   announced --&gt; waiting --next()--&gt; asked --succeeded()--&gt; held --lost()--&gt; waiting
 *                    ^                  |
 *                    +---- failed() ----+   waits 1, 2, 4 ... 30 s; forgotten after 5 in a row
 * </pre>
 *
 * <p>A place is held while the search holds what answered there. What is announced elsewhere with
 * the same service ID is asked all the same: the service ID may be a copy.
 *
 * <p>Order: a place that answered before; then one announced from its own address, which costs a
 * liar an address; then the others. Among equals the one that failed least, then the oldest. A host
 * is asked at one of its places at a time. The last of the {@value #PROBES} probes is kept for
 * places that answered before.
 *
 * <p>Thread-safe.
 */
final class DiscoveryCandidates {

  /** Most places that are remembered. */
  static final int MAX_CANDIDATES = 64;

  /** Most places of one host. */
  static final int PER_HOST = 4;

  /** Most probes at once. */
  static final int PROBES = 4;

  /** An unknown place that failed so often in a row is forgotten. */
  static final int FAILURES = 5;

  /** A place that answered before is forgotten if it fails and was not announced for so long. */
  static final Duration ANNOUNCEMENT_TIMEOUT = Duration.ofMinutes(5);

  static final Duration SHORTEST_WAIT = Duration.ofSeconds(1);
  static final Duration LONGEST_WAIT = Duration.ofSeconds(30);

  /** Where a lookup service may be asked: host and TCP port for unicast discovery. */
  record LookupAddress(String host, int port) {}

  private static final class Candidate {
    final LookupAddress place;
    ServiceID id; // as announced; once it answered, as it claims
    @Nullable LocatedRegistrar held; // what answered here, while the search holds it
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
  private final Map<LookupAddress, Candidate> candidates = new LinkedHashMap<>(); // guarded by this
  private final long origin; // times are differences from it, so that they compare

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
   * A lookup service was announced.
   *
   * @param id what it says that it is
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
    } else if (candidate.failures > 0) { // it is back; a forger gains one probe a second
      candidate.dueAt = Math.min(candidate.dueAt, now + SHORTEST_WAIT.toNanos());
    }
  }

  /** Forgets another where there are too many; false if the new one is the worst. */
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
   * The place to ask now, if there is one; then {@link #succeeded} or {@link #failed} follows.
   *
   * @param others probes that ask somebody else now, who is unknown too
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

  /** Whether one more probe of somebody unknown leaves one for places that answered before. */
  synchronized boolean isRoomForUnknown(int others) {
    long unknown =
        candidates.values().stream().filter(each -> each.isAsked && !each.isKnown).count();
    return unknown + others < PROBES - 1;
  }

  private static boolean isWaiting(Candidate candidate) {
    return !candidate.isAsked && candidate.held == null;
  }

  /** How long until a place that waits is due, in nanoseconds; none where nothing waits. */
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
   * A place answered: this lookup service is there. The place is not asked again until it is lost.
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

  /** A place did not answer, or not as it should. */
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

  /** A place could not be asked for lack of a thread. It is asked later; that is no failure. */
  synchronized void postponed(LookupAddress place) {
    Candidate candidate = candidates.get(place);
    if (candidate != null) {
      candidate.isAsked = false;
      candidate.dueAt = now() + SHORTEST_WAIT.toNanos();
    }
  }

  /**
   * A lookup service is not held any more: it is asked for again, where it was and where one with
   * its service ID was announced.
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

  /** Whether the place answered before. */
  synchronized boolean isKnown(LookupAddress place) {
    Candidate candidate = candidates.get(place);
    return candidate != null && candidate.isKnown;
  }

  /** How many places are remembered. */
  synchronized int size() {
    return candidates.size();
  }
}
