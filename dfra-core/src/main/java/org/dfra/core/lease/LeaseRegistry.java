package org.dfra.core.lease;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.time.Instant;
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
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Grants leases on a module and counts its clients by them. The scheduler ends a lease as soon as
 * it expires, without waiting for the next query.
 *
 * <p>A lease's ID is a secret of its holder and this registry: any client that knows it can renew
 * and cancel the lease. Listings show its {@link LeaseHandle} instead, which can only revoke it.
 *
 * <p>Durations are measured by the scheduler's monotonic clock; the wall clock is used only for the
 * expiration that holders receive.
 */
public final class LeaseRegistry implements AutoCloseable {

  private final String module;
  private final LeaseTerms terms;
  private final InstantSource clock;
  private final Scheduler scheduler;
  private final IntConsumer clientsChanged;
  private final Function<LeaseRole, Executor> expiries;

  private final Map<UUID, LeaseEntry> entries = new HashMap<>(); // guarded by itself

  // the latest only
  @GuardedBy("entries")
  private final Set<UUID> revoked = new HashSet<>();

  @GuardedBy("entries")
  private boolean closed;

  /** Taken before {@link #entries}; keeps notifications in order. */
  private final Object publishLock = new Object();

  @GuardedBy("publishLock")
  private int lastPublished;

  /**
   * @param module the module's path, {@code robot/name}
   * @param clientsChanged receives the number of clients when it changes, in order; must not call
   *     this registry
   */
  public LeaseRegistry(
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
   * @param expiries executors that end expired leases, by the role of the holder; the scheduler
   *     only submits tasks to them, since the callbacks may block. They drop no task.
   */
  public LeaseRegistry(
      String module,
      LeaseTerms terms,
      InstantSource clock,
      Scheduler scheduler,
      IntConsumer clientsChanged,
      Function<LeaseRole, Executor> expiries) {
    this.module = module;
    this.terms = terms;
    this.clock = clock;
    this.scheduler = scheduler;
    this.clientsChanged = clientsChanged;
    this.expiries = expiries;
  }

  /** The terms of the leases granted here. */
  public LeaseTerms terms() {
    return terms;
  }

  /**
   * Grants a lease.
   *
   * @param duration the requested duration
   * @param host address of the holder, for listings; null if unknown
   * @param onEnd run once when it has expired, was revoked or this registry is closed, not when it
   *     is cancelled
   * @throws LeaseRefusedException if it is longer than allowed or not above zero, or the module has
   *     ended
   */
  public LeaseGrant grant(
      Duration duration, LeaseRole holder, @Nullable String host, Runnable onEnd)
      throws LeaseRefusedException {
    return grant(duration, holder, host, onEnd, () -> {});
  }

  /**
   * The same.
   *
   * @param whenCancelled run once when it is cancelled
   */
  public LeaseGrant grant(
      Duration duration,
      LeaseRole holder,
      @Nullable String host,
      Runnable onEnd,
      Runnable whenCancelled)
      throws LeaseRefusedException {
    terms.check(module, duration);
    UUID id = UUID.randomUUID();
    synchronized (entries) {
      refuseIfClosed();
      LeaseEntry entry = entry(id, holder, host, onEnd, whenCancelled);
      extend(id, entry, duration); // first: a lease whose expiry cannot be scheduled is not granted
      entries.put(id, entry);
    }
    publishClientCount();
    return new LeaseGrant(id, duration, clock.instant().plus(duration));
  }

  /**
   * Grants a lease to a holder in this virtual machine; it needs no renewal and is valid until
   * cancelled.
   *
   * @throws LeaseRefusedException if the module has ended
   */
  public UUID grantLocal(LeaseRole holder, Runnable whenOver) throws LeaseRefusedException {
    return grantLocal(holder, whenOver, () -> {});
  }

  /**
   * The same.
   *
   * @param whenCancelled run once when it is cancelled
   */
  public UUID grantLocal(LeaseRole holder, Runnable whenOver, Runnable whenCancelled)
      throws LeaseRefusedException {
    UUID id = UUID.randomUUID();
    synchronized (entries) {
      refuseIfClosed();
      entries.put(id, entry(id, holder, null, whenOver, whenCancelled));
    }
    publishClientCount();
    return id;
  }

  private LeaseEntry entry(
      UUID id, LeaseRole holder, @Nullable String host, Runnable whenOver, Runnable whenCancelled) {
    return new LeaseEntry(
        id, holder, host, clock.instant(), scheduler.nanos(), whenOver, whenCancelled);
  }

  @GuardedBy("entries")
  private void refuseIfClosed() throws LeaseRefusedException {
    if (closed) {
      throw new LeaseRefusedException(module + " grants no leases any more; it has ended");
    }
  }

  /**
   * Renews a lease, from now on.
   *
   * @return empty if the lease no longer exists
   * @throws LeaseRefusedException as for {@link #grant}; the lease stays as it was
   */
  public Optional<LeaseGrant> renew(UUID id, Duration duration) throws LeaseRefusedException {
    terms.check(module, duration);
    synchronized (entries) {
      LeaseEntry entry = entries.get(id);
      if (entry == null) {
        return Optional.empty();
      }
      extend(id, entry, duration);
    }
    return Optional.of(new LeaseGrant(id, duration, clock.instant().plus(duration)));
  }

  /**
   * Prolongs a lease because its holder has proved that it lives, as by accepting an event: it ends
   * the default duration from now or, if that is later, as before.
   *
   * @return false if the lease no longer exists; then nothing changes
   */
  public boolean prolong(UUID id) {
    synchronized (entries) {
      LeaseEntry entry = entries.get(id);
      if (entry == null) {
        return false;
      }
      long end = scheduler.nanos() + terms.defaultDuration().toNanos();
      if (entry.expiry != null && end - entry.end > 0) {
        entry.end = end; // its expiry is scheduled again when it is due
      }
      return true;
    }
  }

  /** Cancels a lease; false if it no longer exists. */
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
    publishAndRun(entry.holder, entry.onCancel);
    return true;
  }

  /**
   * Revokes a lease on behalf of an administrator.
   *
   * @return false if it no longer exists
   */
  public boolean revoke(UUID id) {
    return end(id, true);
  }

  private boolean end(UUID id, boolean isRemembered) {
    LeaseEntry entry;
    synchronized (entries) {
      entry = entries.remove(id);
      if (entry == null) {
        return false;
      }
      if (entry.expiry != null) {
        entry.expiry.cancel();
        if (isRemembered) {
          remember(id);
        }
      }
    }
    publishAndRun(entry.holder, entry.onEnd);
    return true;
  }

  /**
   * Revokes a lease as if it had expired: on the executor of its holder's role, since callbacks may
   * block.
   */
  public void revokeInBackground(UUID id) {
    endInBackground(id, true);
  }

  /**
   * Lets a lease expire now, on the executor of its holder's role. Unlike after a revocation, its
   * holder may ask for another one.
   */
  public void expireInBackground(UUID id) {
    endInBackground(id, false);
  }

  private void endInBackground(UUID id, boolean isRemembered) {
    LeaseRole holder;
    synchronized (entries) {
      LeaseEntry entry = entries.get(id);
      if (entry == null) {
        return;
      }
      holder = entry.holder;
    }
    expiries
        .apply(holder)
        .execute(
            () -> {
              boolean unused = end(id, isRemembered);
            });
  }

  /** As {@link #revoke(UUID)}, by the handle that listings show. */
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

  /** Keeps the ID long enough that a failed renewal can report the reason. */
  @GuardedBy("entries")
  private void remember(UUID id) {
    revoked.add(id);
    ScheduledTask unused =
        scheduler.after(
            terms.maxDuration().toNanos(),
            () -> {
              synchronized (entries) {
                revoked.remove(id);
              }
            });
  }

  /** Whether the lease existed and was revoked within the last maximum lease duration. */
  public boolean isRevoked(UUID id) {
    synchronized (entries) {
      return revoked.contains(id);
    }
  }

  /** All current leases, the oldest first. */
  public List<LeaseStatus> leases() {
    synchronized (entries) {
      long now = scheduler.nanos();
      return entries.values().stream()
          .map(each -> each.status(now))
          .sorted(
              Comparator.comparing(LeaseStatus::age).reversed().thenComparing(LeaseStatus::handle))
          .toList();
    }
  }

  /** Whether the lease exists. */
  public boolean contains(UUID id) {
    synchronized (entries) {
      return entries.containsKey(id);
    }
  }

  /** The number of clients that hold a lease. */
  public int clients() {
    synchronized (entries) {
      return (int) entries.values().stream().filter(entry -> entry.holder.isClient()).count();
    }
  }

  /** Ends every lease, and grants no more. */
  @Override
  public void close() {
    Map<UUID, LeaseEntry> over;
    synchronized (entries) {
      closed = true;
      over = new HashMap<>(entries);
      entries.clear();
    }
    List<Runnable> steps = new ArrayList<>();
    over.values().stream().filter(LeaseRegistry::commands).forEach(each -> steps.add(each.onEnd));
    steps.add(this::publishClientCount);
    over.values().stream().filter(each -> !commands(each)).forEach(e -> steps.add(e.onEnd));
    over.values().forEach(LeaseRegistry::cancelExpiry);
    runAll(steps);
  }

  private static boolean commands(LeaseEntry entry) {
    return entry.holder == LeaseRole.COMMANDER;
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
      } catch (RuntimeException e) { // the others must be notified too
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

  /** If its expiry cannot be scheduled the lease is unchanged. */
  private void extend(UUID id, LeaseEntry entry, Duration asked) {
    long end = scheduler.nanos() + asked.toNanos();
    int term = entry.term + 1;
    ScheduledTask expiry = expiryAfter(asked.toNanos(), id, entry, term);
    cancelExpiry(entry);
    entry.term = term;
    entry.end = end;
    entry.expiry = expiry;
  }

  private ScheduledTask expiryAfter(long nanos, UUID id, LeaseEntry entry, int term) {
    Executor ending = expiries.apply(entry.holder);
    return scheduler.after(nanos, () -> ending.execute(() -> expire(id, term)));
  }

  private void expire(UUID id, int term) {
    LeaseEntry entry;
    synchronized (entries) {
      entry = entries.get(id);
      if (entry == null || entry.term != term) {
        return; // cancelled or renewed meanwhile
      }
      long left = entry.end - scheduler.nanos();
      if (left > 0 && isScheduledAgain(id, entry, left)) {
        return; // prolonged meanwhile
      }
      entries.remove(id);
    }
    publishAndRun(entry.holder, entry.onEnd);
  }

  /** If the expiry of a prolonged lease cannot be scheduled, it ends now: better than never. */
  private boolean isScheduledAgain(UUID id, LeaseEntry entry, long nanos) {
    try {
      entry.expiry = expiryAfter(nanos, id, entry, entry.term);
      return true;
    } catch (OutOfMemoryError e) { // the timer has no thread
      return false;
    }
  }

  /**
   * Publishes the number of remaining clients, and runs {@code then}, even if one of the two fails.
   * The end of a commander's lease halts the device and runs first, since listeners may be slow.
   */
  private void publishAndRun(LeaseRole holder, Runnable then) {
    boolean isFirst = holder == LeaseRole.COMMANDER;
    try {
      (isFirst ? then : (Runnable) this::publishClientCount).run();
    } finally {
      (isFirst ? (Runnable) this::publishClientCount : then).run();
    }
  }

  private void publishClientCount() {
    synchronized (publishLock) {
      int clients = clients();
      if (clients != lastPublished) {
        lastPublished = clients;
        clientsChanged.accept(clients);
      }
    }
  }

  /**
   * A granted or renewed lease.
   *
   * @param id its identity: a secret of holder and grantor
   * @param duration its duration from now
   * @param expiration when it expires, by the module's clock
   */
  public record LeaseGrant(UUID id, Duration duration, Instant expiration) {}
}
