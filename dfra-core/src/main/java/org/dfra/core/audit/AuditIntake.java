package org.dfra.core.audit;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.audit.CountedKeys.Added;
import org.dfra.core.audit.CountedKeys.Counted;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.jspecify.annotations.Nullable;

/**
 * What callers do with the trail: they count and enqueue, and never wait. Thread-safe; the thread
 * of the {@link AuditWriter} takes.
 */
final class AuditIntake {

  /** Different callers and methods whose reads are summed. */
  static final int MOST_READS = 4_096;

  private static final String QUEUE_FULL = "the queue was full: the disk was too slow";
  private static final String TOO_MANY = "there were too many different events in the interval";
  private static final String NOT_WRITTEN = "they could not be written";

  /** What the thread takes from the queue. */
  sealed interface Item permits Queued, Request {}

  /** A record. */
  record Queued(AuditEntry entry) implements Item {}

  /**
   * Asks for all sums, and for the disk.
   *
   * @param done the end of the chain on the disk, or why it is not there
   */
  record Request(CompletableFuture<TrailPosition> done) implements Item {}

  private final AuditSettings settings;
  private final InstantSource clock;
  private final BlockingQueue<Item> queue;
  private final CountedKeys<ReadKey> reads = new CountedKeys<>(MOST_READS);
  private final CountedKeys<AuditEvent> repeats;
  private final AtomicInteger rate = new AtomicInteger();
  private final AtomicInteger strangersRate = new AtomicInteger();
  private final AtomicLong otherReads = new AtomicLong();
  private final AtomicLong queueFull = new AtomicLong();
  private final AtomicLong tooMany = new AtomicLong();
  private final AtomicLong notWritten = new AtomicLong();
  private final AtomicLong dropped = new AtomicLong();
  private volatile Instant intervalBegin;

  AuditIntake(AuditSettings settings, InstantSource clock) {
    this.settings = settings;
    this.clock = clock;
    queue = new ArrayBlockingQueue<>(settings.queue());
    // those of this interval, and those of the last one that still repeat
    repeats =
        new CountedKeys<>(2 * (settings.ratePerInterval() + settings.strangersRatePerInterval()));
    intervalBegin = clock.instant();
  }

  BlockingQueue<Item> queue() {
    return queue;
  }

  Instant now() {
    return clock.instant();
  }

  /** Number of events without a record. */
  long dropped() {
    return dropped.get();
  }

  /** Counts a permitted call that only reads. */
  void addRead(AccessRequest request) {
    ReadKey key = new ReadKey(request);
    if (!reads.count(key) && reads.add(key, 1) == Added.FULL) {
      otherReads.incrementAndGet();
    }
  }

  /** Enqueues an event, or counts it if an equal one is known. */
  void add(AuditEvent event) {
    if (repeats.count(event)) {
      return;
    }
    if (!isWithinRate(event)) {
      drop(tooMany, 1);
      return;
    }
    switch (repeats.add(event, 0)) {
      case FIRST -> {
        if (!queue.offer(new Queued(AuditEntry.single(event, clock.instant())))) {
          drop(queueFull, 1);
        }
      }
      case FULL -> drop(tooMany, 1);
      case COUNTED -> {
        // another thread has just added an equal one
      }
    }
  }

  /**
   * So that a flood of strangers leaves the members' events their records. A member that carries a
   * credential that proves nothing chooses what the refusal says, so it counts as they do.
   */
  private boolean isWithinRate(AuditEvent event) {
    Optional<Standing> standing = event.caller().map(Caller::standing);
    boolean isStranger =
        standing.isPresent()
            && (standing.get() == Standing.STRANGER || standing.get() == Standing.EXPIRED);
    boolean isUnproved =
        event
            .caller()
            .flatMap(Caller::behalf)
            .map(each -> each.principal().isEmpty())
            .orElse(false);
    return isStranger || isUnproved
        ? strangersRate.incrementAndGet() <= settings.strangersRatePerInterval()
        : rate.incrementAndGet() <= settings.ratePerInterval();
  }

  private void drop(AtomicLong reason, long events) {
    reason.addAndGet(events);
    dropped.addAndGet(events);
  }

  /** Takes note of records that could not be written. */
  void addLost(List<AuditEntry> lost) {
    for (AuditEntry each : lost) {
      if (each.event().kind() == AuditKind.RECORDS_DROPPED) {
        notWritten.addAndGet(each.count()); // they are in the total already
      } else {
        drop(notWritten, each.count());
      }
    }
  }

  /** Ends the interval: takes the sums of reads and of equal events, and what was dropped. */
  List<AuditEntry> takeSums() {
    Instant now = clock.instant();
    Optional<Instant> since = Optional.of(intervalBegin);
    intervalBegin = now;
    List<AuditEntry> sums = new ArrayList<>();
    for (Counted<AuditEvent> each : repeats.take()) {
      sums.add(new AuditEntry(each.key(), now, each.count(), since));
    }
    for (Counted<ReadKey> each : reads.take()) {
      sums.add(new AuditEntry(each.key().event(), now, each.count(), since));
    }
    addSum(AuditKind.READS, "of further callers and methods", otherReads, since, sums);
    addSum(AuditKind.RECORDS_DROPPED, QUEUE_FULL, queueFull, since, sums);
    addSum(AuditKind.RECORDS_DROPPED, TOO_MANY, tooMany, since, sums);
    addSum(AuditKind.RECORDS_DROPPED, NOT_WRITTEN, notWritten, since, sums);
    rate.set(0);
    strangersRate.set(0);
    return sums;
  }

  private void addSum(
      AuditKind kind,
      String reason,
      AtomicLong count,
      Optional<Instant> since,
      List<AuditEntry> sums) {
    long taken = count.getAndSet(0);
    if (taken > 0) {
      AuditEvent event = AuditEvent.ofProcess(kind, "", reason);
      sums.add(new AuditEntry(event, intervalBegin, taken, since));
    }
  }

  /**
   * A caller and a method. Its hash leaves out what seldom differs, since it is computed for each
   * read.
   */
  private record ReadKey(AccessRequest request) {

    AuditEvent event() {
      return new AuditEvent(
          AuditKind.READS,
          Optional.of(request.caller()),
          request.robot(),
          request.object(),
          request.methodName(),
          AuditEvent.PERMIT,
          "",
          "",
          List.of());
    }

    @Override
    public int hashCode() {
      int hash = request.caller().address().hashCode();
      hash = 31 * hash + request.object().hashCode();
      return 31 * hash + request.method().getName().hashCode();
    }

    @Override
    public boolean equals(@Nullable Object other) {
      if (!(other instanceof ReadKey key)) {
        return false;
      }
      AccessRequest one = request;
      AccessRequest two = key.request;
      return one.object().equals(two.object())
          && one.robot().equals(two.robot())
          && (one.method() == two.method() || one.method().equals(two.method()))
          && CallerEquality.areEqual(one.caller(), two.caller());
    }
  }
}
