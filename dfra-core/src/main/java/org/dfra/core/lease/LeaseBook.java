package org.dfra.core.lease;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.IntConsumer;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseStatus;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.Task;
import org.jspecify.annotations.Nullable;

/**
 * Grants leases on a module and counts its clients by them. A lease that is not renewed is over
 * when its time is, not when somebody asks: its end is noticed by the scheduler.
 *
 * <p>Time is the scheduler's, which nobody sets; the clock only tells holders when their lease
 * ends.
 */
public final class LeaseBook implements AutoCloseable {

  private final String module;
  private final LeaseTerms terms;
  private final InstantSource clock;
  private final Scheduler scheduler;
  private final IntConsumer clientsChanged;
  private final Executor expiries;

  private final Map<UUID, Entry> entries = new HashMap<>(); // guarded by itself
  private final Set<UUID> revoked = new HashSet<>(); // guarded by entries; the latest only
  private boolean closed; // guarded by entries

  /** Taken before {@link #entries}; keeps what is told in order. */
  private final Object telling = new Object();

  private int lastTold; // guarded by telling

  /**
   * @param module the module's path, {@code robot/name}
   * @param clientsChanged is told how many clients there are when that changes, in order; must not
   *     call this book
   */
  public LeaseBook(
      String module,
      LeaseTerms terms,
      InstantSource clock,
      Scheduler scheduler,
      IntConsumer clientsChanged) {
    this(module, terms, clock, scheduler, clientsChanged, Runnable::run);
  }

  /**
   * The same.
   *
   * @param expiries ends those leases that were not renewed; the scheduler only hands over to it,
   *     since whoever hears of the end may be held up
   */
  public LeaseBook(
      String module,
      LeaseTerms terms,
      InstantSource clock,
      Scheduler scheduler,
      IntConsumer clientsChanged,
      Executor expiries) {
    this.module = module;
    this.terms = terms;
    this.clock = clock;
    this.scheduler = scheduler;
    this.clientsChanged = clientsChanged;
    this.expiries = expiries;
  }

  /** One lease. */
  private static final class Entry {
    final Holder holder;
    final @Nullable String host;
    final Instant since;
    final Runnable whenOver;
    final Runnable whenCancelled;
    long end; // guarded by entries; nothing where there is no expiry
    @Nullable Task expiry; // guarded by entries; null where nobody need renew

    Entry(
        Holder holder,
        @Nullable String host,
        Instant since,
        Runnable whenOver,
        Runnable whenCancelled) {
      this.holder = holder;
      this.host = host;
      this.since = since;
      this.whenOver = whenOver;
      this.whenCancelled = whenCancelled;
    }
  }

  /** What is granted here. */
  public LeaseTerms terms() {
    return terms;
  }

  /**
   * Grants a lease.
   *
   * @param asked how long
   * @param host address of the holder, for those who ask who holds what; null where it is not known
   * @param whenOver run once when it has expired, was revoked or this book is closed, not when it
   *     is cancelled
   * @throws LeaseRefusedException if it is longer than allowed or not above zero, or the module has
   *     ended
   */
  public Grant grant(Duration asked, Holder holder, @Nullable String host, Runnable whenOver)
      throws LeaseRefusedException {
    return grant(asked, holder, host, whenOver, () -> {});
  }

  /**
   * The same.
   *
   * @param whenCancelled run once when it is cancelled
   */
  public Grant grant(
      Duration asked,
      Holder holder,
      @Nullable String host,
      Runnable whenOver,
      Runnable whenCancelled)
      throws LeaseRefusedException {
    terms.check(module, asked);
    UUID id = UUID.randomUUID();
    synchronized (entries) {
      refuseIfClosed();
      Entry entry = new Entry(holder, host, clock.instant(), whenOver, whenCancelled);
      entries.put(id, entry);
      extend(id, entry, asked);
    }
    tell();
    return new Grant(id, asked, clock.instant().plus(asked));
  }

  /**
   * Counts a holder in this virtual machine until it says otherwise; nobody need renew it.
   *
   * @throws LeaseRefusedException if the module has ended
   */
  public UUID hold(Holder holder, Runnable whenOver) throws LeaseRefusedException {
    return hold(holder, whenOver, () -> {});
  }

  /**
   * The same.
   *
   * @param whenCancelled run once when it is cancelled
   */
  public UUID hold(Holder holder, Runnable whenOver, Runnable whenCancelled)
      throws LeaseRefusedException {
    UUID id = UUID.randomUUID();
    synchronized (entries) {
      refuseIfClosed();
      entries.put(id, new Entry(holder, null, clock.instant(), whenOver, whenCancelled));
    }
    tell();
    return id;
  }

  private void refuseIfClosed() throws LeaseRefusedException {
    if (closed) {
      throw new LeaseRefusedException(module + " grants no leases any more; it has ended");
    }
  }

  /**
   * Renews a lease, from now on.
   *
   * @return nothing if there is no such lease any more
   * @throws LeaseRefusedException as for {@link #grant}; the lease stays as it was
   */
  public Optional<Grant> renew(UUID id, Duration asked) throws LeaseRefusedException {
    terms.check(module, asked);
    synchronized (entries) {
      Entry entry = entries.get(id);
      if (entry == null) {
        return Optional.empty();
      }
      extend(id, entry, asked);
    }
    return Optional.of(new Grant(id, asked, clock.instant().plus(asked)));
  }

  /** Ends a lease before its time; false if there is no such lease any more. */
  public boolean cancel(UUID id) {
    Entry entry;
    synchronized (entries) {
      entry = entries.remove(id);
      if (entry == null) {
        return false;
      }
      if (entry.expiry != null) {
        entry.expiry.cancel();
      }
    }
    tellAnd(entry.whenCancelled);
    return true;
  }

  /**
   * Ends a lease before its time, against its holder's will.
   *
   * @return false if there is no such lease any more
   */
  public boolean revoke(UUID id) {
    Entry entry;
    synchronized (entries) {
      entry = entries.remove(id);
      if (entry == null) {
        return false;
      }
      if (entry.expiry != null) {
        entry.expiry.cancel();
        remember(id);
      }
    }
    tellAnd(entry.whenOver);
    return true;
  }

  /** Long enough for whoever renews it to hear why that fails. */
  private void remember(UUID id) {
    revoked.add(id);
    Task unused =
        scheduler.after(
            terms.longest().toNanos(),
            () -> {
              synchronized (entries) {
                revoked.remove(id);
              }
            });
  }

  /** Whether there was such a lease, and it was revoked not longer ago than the longest lasts. */
  public boolean isRevoked(UUID id) {
    synchronized (entries) {
      return revoked.contains(id);
    }
  }

  /** Every lease there is now, the oldest first. */
  public List<LeaseStatus> leases() {
    synchronized (entries) {
      return entries.entrySet().stream()
          .map(each -> status(each.getKey(), each.getValue()))
          .sorted(Comparator.comparing(LeaseStatus::since).thenComparing(LeaseStatus::id))
          .toList();
    }
  }

  private LeaseStatus status(UUID id, Entry entry) {
    return new LeaseStatus(
        id,
        entry.holder,
        entry.host,
        entry.since,
        entry.expiry == null ? null : Duration.ofNanos(Math.max(0, entry.end - scheduler.nanos())));
  }

  /** Whether there is such a lease. */
  public boolean holds(UUID id) {
    synchronized (entries) {
      return entries.containsKey(id);
    }
  }

  /** How many clients hold a lease now. */
  public int clients() {
    synchronized (entries) {
      return (int) entries.values().stream().filter(entry -> entry.holder.isClient()).count();
    }
  }

  /** Ends every lease, and grants none any more. */
  @Override
  public void close() {
    Map<UUID, Entry> over;
    synchronized (entries) {
      closed = true;
      over = new HashMap<>(entries);
      entries.clear();
    }
    tellAnd(() -> end(over.values()));
  }

  private static void end(Collection<Entry> over) {
    RuntimeException failure = null;
    for (Entry entry : over) {
      if (entry.expiry != null) {
        entry.expiry.cancel();
      }
      try {
        entry.whenOver.run();
      } catch (RuntimeException e) { // the others must hear of it too
        failure = failure == null ? e : failure;
        if (failure != e) {
          failure.addSuppressed(e);
        }
      }
    }
    if (failure != null) {
      throw failure;
    }
  }

  private void extend(UUID id, Entry entry, Duration asked) {
    entry.end = scheduler.nanos() + asked.toNanos();
    if (entry.expiry != null) {
      entry.expiry.cancel();
    }
    entry.expiry = scheduler.after(asked.toNanos(), () -> expiries.execute(() -> expire(id)));
  }

  private void expire(UUID id) {
    Entry entry;
    synchronized (entries) {
      entry = entries.get(id);
      if (entry == null || scheduler.nanos() - entry.end < 0) {
        return; // cancelled or renewed meanwhile
      }
      entries.remove(id);
    }
    tellAnd(entry.whenOver);
  }

  /** Tells how many clients are left, and runs {@code then} even where that fails. */
  private void tellAnd(Runnable then) {
    try {
      tell();
    } finally {
      then.run();
    }
  }

  private void tell() {
    synchronized (telling) {
      int clients = clients();
      if (clients != lastTold) {
        lastTold = clients;
        clientsChanged.accept(clients);
      }
    }
  }
}
