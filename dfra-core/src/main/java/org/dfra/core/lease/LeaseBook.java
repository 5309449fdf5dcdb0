package org.dfra.core.lease;

import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.dfra.lease.Holder;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseStatus;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.Task;
import org.jspecify.annotations.Nullable;

/**
 * Grants leases on a module and counts its clients by them. A lease that is not renewed is over
 * when its time is, not when somebody asks: its end is noticed by the scheduler.
 *
 * <p>A lease's ID is a secret of its holder and this book: whoever knows it can renew and cancel
 * the lease. Listings show its {@link LeaseHandle} instead, which only revokes it.
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
  private final Function<Holder, Executor> expiries;

  private final Map<UUID, LeaseEntry> entries = new HashMap<>(); // guarded by itself
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
    this(module, terms, clock, scheduler, clientsChanged, holder -> Runnable::run);
  }

  /**
   * The same.
   *
   * @param expiries ends those leases that were not renewed, by what their holders are; the
   *     scheduler only hands over to it, since whoever hears of the end may be held up. It drops no
   *     task.
   */
  public LeaseBook(
      String module,
      LeaseTerms terms,
      InstantSource clock,
      Scheduler scheduler,
      IntConsumer clientsChanged,
      Function<Holder, Executor> expiries) {
    this.module = module;
    this.terms = terms;
    this.clock = clock;
    this.scheduler = scheduler;
    this.clientsChanged = clientsChanged;
    this.expiries = expiries;
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
      LeaseEntry entry = entry(id, holder, host, whenOver, whenCancelled);
      extend(id, entry, asked); // first: what cannot be ended in time is not granted
      entries.put(id, entry);
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
      entries.put(id, entry(id, holder, null, whenOver, whenCancelled));
    }
    tell();
    return id;
  }

  private LeaseEntry entry(
      UUID id, Holder holder, @Nullable String host, Runnable whenOver, Runnable whenCancelled) {
    return new LeaseEntry(
        id, holder, host, clock.instant(), scheduler.nanos(), whenOver, whenCancelled);
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
      LeaseEntry entry = entries.get(id);
      if (entry == null) {
        return Optional.empty();
      }
      extend(id, entry, asked);
    }
    return Optional.of(new Grant(id, asked, clock.instant().plus(asked)));
  }

  /** Ends a lease before its time; false if there is no such lease any more. */
  public boolean cancel(UUID id) {
    LeaseEntry entry;
    synchronized (entries) {
      entry = entries.remove(id);
      if (entry == null) {
        return false;
      }
      if (entry.expiry != null) {
        entry.expiry.cancel();
      }
    }
    tellAnd(entry.holder, entry.whenCancelled);
    return true;
  }

  /**
   * Ends a lease before its time, against its holder's will.
   *
   * @return false if there is no such lease any more
   */
  public boolean revoke(UUID id) {
    LeaseEntry entry;
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
    tellAnd(entry.holder, entry.whenOver);
    return true;
  }

  /** The same, by what listings show of it. */
  public boolean revoke(LeaseHandle handle) {
    Optional<UUID> id;
    synchronized (entries) {
      id =
          entries.entrySet().stream()
              .filter(each -> each.getValue().handle.equals(handle))
              .map(Map.Entry::getKey)
              .findFirst();
    }
    return id.isPresent() && revoke(id.get());
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
      long now = scheduler.nanos();
      return entries.values().stream()
          .map(each -> each.status(now))
          .sorted(
              Comparator.comparing(LeaseStatus::held).reversed().thenComparing(LeaseStatus::handle))
          .toList();
    }
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
    Map<UUID, LeaseEntry> over;
    synchronized (entries) {
      closed = true;
      over = new HashMap<>(entries);
      entries.clear();
    }
    List<Runnable> steps = new ArrayList<>();
    over.values().stream().filter(LeaseBook::commands).forEach(each -> steps.add(each.whenOver));
    steps.add(this::tell);
    over.values().stream().filter(each -> !commands(each)).forEach(e -> steps.add(e.whenOver));
    over.values().forEach(LeaseBook::cancelExpiry);
    runAll(steps);
  }

  private static boolean commands(LeaseEntry entry) {
    return entry.holder == Holder.COMMANDER;
  }

  private static void cancelExpiry(LeaseEntry entry) {
    if (entry.expiry != null) {
      entry.expiry.cancel();
    }
  }

  private static void runAll(List<Runnable> steps) {
    RuntimeException failure = null;
    for (Runnable step : steps) {
      try {
        step.run();
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

  /** Where its end cannot be scheduled the lease stays as it was. */
  private void extend(UUID id, LeaseEntry entry, Duration asked) {
    long end = scheduler.nanos() + asked.toNanos();
    Executor ending = expiries.apply(entry.holder);
    Task expiry = scheduler.after(asked.toNanos(), () -> ending.execute(() -> expire(id)));
    cancelExpiry(entry);
    entry.end = end;
    entry.expiry = expiry;
  }

  private void expire(UUID id) {
    LeaseEntry entry;
    synchronized (entries) {
      entry = entries.get(id);
      if (entry == null || scheduler.nanos() - entry.end < 0) {
        return; // cancelled or renewed meanwhile
      }
      entries.remove(id);
    }
    tellAnd(entry.holder, entry.whenOver);
  }

  /**
   * Tells how many clients are left, and runs {@code then}, whichever of the two fails. The end of
   * a commander's lease halts the device and comes first, since those who are told may be slow.
   */
  private void tellAnd(Holder holder, Runnable then) {
    boolean isFirst = holder == Holder.COMMANDER;
    try {
      (isFirst ? then : (Runnable) this::tell).run();
    } finally {
      (isFirst ? (Runnable) this::tell : then).run();
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
