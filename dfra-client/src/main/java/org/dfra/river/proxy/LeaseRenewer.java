package org.dfra.river.proxy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseException;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.river.call.CallThreads;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.proxy.JointRenewal.DueLease;
import org.dfra.river.remote.LeaseRevokedException;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Maintains a lease at a server until its owner closes it. It renews the lease, and requests a new
 * one if the server has lost it or was restarted.
 *
 * <p>It checks the lease every {@value #PERIOD_MILLIS} ms, more often if the lease is short, and
 * once more soon after the first failed call. Leases of the same landlord that are due within half
 * a period are renewed by one call; what becomes of one of them does not affect the others. While
 * {@linkplain #renewedByPeer the server proves} that it renews the lease by itself, no call is
 * made.
 *
 * <p>All renewers of this virtual machine share one timer thread, which only dispatches. Threads
 * that exist during a call make the calls, so an unresponsive server delays no other renewal. The
 * lease's duration is measured in monotonic time: a change of the system clock neither ends nor
 * prolongs it. The timer references the renewer. It ends when it is closed, when its lease was
 * revoked, or when it has lost a lease that may not be requested again.
 */
final class LeaseRenewer implements AutoCloseable {

  /** Requests a lease from a server. */
  @FunctionalInterface
  interface LeaseRequest {

    /**
     * @throws LeaseRevokedException if the lease has ended and must not be requested again
     */
    Lease register() throws RemoteException, LeaseRefusedException, LeaseRevokedException;
  }

  /** With the usual deadline of 2 s, an unresponsive server is detected within 3 s. */
  private static final long PERIOD_MILLIS = 800;

  /**
   * The delay after the first failed call. When a server is killed, the running call fails, and the
   * next one reactivates the server.
   */
  private static final long RETRY_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

  /** Fewer than a landlord allows. */
  private static final int MAX_TOGETHER = 256;

  private static final System.Logger LOG = System.getLogger(LeaseRenewer.class.getName());
  private static final ThreadPoolExecutor CALLERS = CallThreads.pool("dfra-renewal-");

  private final String what;
  private final LeaseRequest registration;
  private final boolean comesBack;
  private final long duration;
  private final long periodNanos;
  private final Scheduler scheduler;
  private final Executor callers;
  private final @Nullable ClassLoader loader = Thread.currentThread().getContextClassLoader();

  @GuardedBy("this")
  private Lease lease;

  // of the lease unless it is renewed; the scheduler's time
  @GuardedBy("this")
  private long end;

  // what the server grants for this lease, at least
  @GuardedBy("this")
  private long leastGranted;

  // when it had renewed the lease by itself, by the scheduler's time; meaningless without proof
  @GuardedBy("this")
  private long provenAt;

  @GuardedBy("this")
  private boolean isProven;

  @GuardedBy("this")
  private boolean closed;

  // for people
  @GuardedBy("this")
  private @Nullable Instant interruptedSince;

  // the same, by the scheduler's time
  @GuardedBy("this")
  private long interruptedNanos;

  // the last call failed, and none before it
  @GuardedBy("this")
  private boolean justMissed;

  @GuardedBy("this")
  private @Nullable ScheduledTask next;

  // when that runs, by the scheduler's time
  @GuardedBy("this")
  private long due;

  // whether a thread checks the lease, or will at once
  @GuardedBy("this")
  private boolean busy;

  /**
   * @param what the lease, for the log
   * @param duration the duration to request, milliseconds; {@link Lease#ANY} for the server's
   *     choice
   * @param lease the first lease
   */
  LeaseRenewer(
      String what, LeaseRequest registration, long duration, Lease lease, Scheduler scheduler) {
    this(what, registration, true, duration, lease, scheduler, CALLERS);
  }

  /** For a lease that is not requested again once it is lost; see above. */
  LeaseRenewer(String what, long duration, Lease lease, Scheduler scheduler) {
    this(what, duration, lease, scheduler, CALLERS);
  }

  /** For tests: with threads that can fail to start. */
  LeaseRenewer(String what, long duration, Lease lease, Scheduler scheduler, Executor callers) {
    this(
        what,
        () -> {
          throw new LeaseRevokedException("it was lost; to continue, request a new one");
        },
        false,
        duration,
        lease,
        scheduler,
        callers);
  }

  private LeaseRenewer(
      String what,
      LeaseRequest registration,
      boolean comesBack,
      long duration,
      Lease lease,
      Scheduler scheduler,
      Executor callers) {
    this.what = what;
    this.registration = registration;
    this.comesBack = comesBack;
    this.duration = duration;
    this.lease = lease;
    this.scheduler = scheduler;
    this.callers = callers;
    long granted = grantedNanos(lease);
    this.end = scheduler.nanos() + granted;
    this.leastGranted = granted;
    this.periodNanos = Math.min(TimeUnit.MILLISECONDS.toNanos(PERIOD_MILLIS), granted / 3);
  }

  /**
   * The duration of a lease that was granted or renewed just now. It is sent as a duration, and
   * converted to a time of this computer's clock on arrival. This converts it back before the clock
   * may be set.
   */
  private long grantedNanos(Lease fresh) {
    long granted = Math.max(1, fresh.getExpiration() - System.currentTimeMillis());
    return TimeUnit.MILLISECONDS.toNanos(duration > 0 ? Math.min(granted, duration) : granted);
  }

  /**
   * The first lease was requested at this time, of the scheduler. The server counts its duration
   * from some time after that, so nobody here takes it for longer than the server does.
   *
   * @return this
   */
  synchronized LeaseRenewer requestedAt(long asked) {
    end = Math.min(end, asked + leastGranted);
    return this;
  }

  /** Starts to maintain the lease. */
  synchronized void start() {
    if (!closed) {
      HeldLeaseRegistry.add(lease);
      RenewalGroups.SHARED.join(this, lease);
      scheduleNext();
    }
  }

  private synchronized void scheduleNext() {
    if (!closed) {
      schedule(justMissed ? Math.min(RETRY_NANOS, periodNanos) : periodNanos);
      justMissed = false;
    }
  }

  @GuardedBy("this")
  private void schedule(long nanos) {
    busy = false;
    due = scheduler.nanos() + nanos;
    next = scheduler.after(nanos, this::send);
  }

  /** Called on the timer's thread: dispatches the check of the lease to another thread. */
  private void send() {
    synchronized (this) {
      if (closed || busy) {
        return;
      }
      long left = nanosUntilDue();
      if (left > 0) {
        schedule(left);
        return;
      }
      busy = true;
    }
    dispatch(this::look);
  }

  private void dispatch(Runnable check) {
    try {
      callers.execute(check);
    } catch (OutOfMemoryError e) { // no further thread
      LOG.log(Level.WARNING, () -> what + ": no thread to renew it, trying again: " + e);
      scheduleNext();
    }
  }

  /** Until the next call must be made: a period after the last proof, if that is later. */
  @GuardedBy("this")
  private long nanosUntilDue() {
    long now = scheduler.nanos();
    long left = due - now;
    return isProven && interruptedSince == null
        ? Math.max(left, provenAt + periodNanos - now)
        : left;
  }

  /**
   * The server has proved that it renewed the lease by itself, after accepting a delivery.
   *
   * @param at a time before that, by the scheduler: the lease lasts at least its duration from then
   */
  synchronized void renewedByPeer(long at) {
    if (closed || isOver()) {
      return; // in doubt, the server is asked
    }
    if (at + leastGranted - end > 0) {
      end = at + leastGranted;
    }
    if (!isProven || at - provenAt > 0) {
      isProven = true;
      provenAt = at;
    }
  }

  /** Since when the server has not answered; empty if it answers. */
  synchronized Optional<Instant> interruptedSince() {
    return Optional.ofNullable(interruptedSince);
  }

  /** When the lease expires unless it is renewed. */
  synchronized Instant expiration() {
    return Instant.now().plusNanos(end - scheduler.nanos()).truncatedTo(ChronoUnit.MILLIS);
  }

  /** Whether the lease is held, as far as is known. */
  synchronized boolean isLive() {
    return !closed && !isOver();
  }

  /** Whether it has ended. */
  synchronized boolean isClosed() {
    return closed;
  }

  @GuardedBy("this")
  private boolean isOver() {
    return scheduler.nanos() - end >= 0;
  }

  /** Cancels the lease, in the background; see {@link PendingLeaseCancellations}. Idempotent. */
  @Override
  public void close() {
    CompletableFuture<Void> unused = cancel();
  }

  /** As {@link #close}; the result completes when the lease is cancelled, or cannot be. */
  synchronized CompletableFuture<Void> cancel() {
    if (closed) {
      return CompletableFuture.completedFuture(null);
    }
    closed = true;
    if (next != null) {
      next.cancel();
    }
    Lease last = lease;
    HeldLeaseRegistry.remove(last);
    RenewalGroups.SHARED.leave(this);
    return PendingLeaseCancellations.run(CALLERS, () -> cancelLease(last));
  }

  private void look() {
    inContext(this::lookAfterIt);
  }

  private void inContext(Runnable check) {
    Thread thread = Thread.currentThread();
    @Nullable ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(loader);
    try {
      check.run();
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  private void lookAfterIt() {
    Lease held;
    boolean over;
    synchronized (this) {
      if (closed) {
        return;
      }
      held = lease;
      over = isOver();
    }
    if (over) {
      registerAgain();
      return;
    }
    List<DueLease> together = new ArrayList<>();
    together.add(new DueLease(this, held, duration));
    for (LeaseRenewer each : RenewalGroups.SHARED.others(this)) {
      @Nullable DueLease claimed = together.size() < MAX_TOGETHER ? each.claim() : null;
      if (claimed != null) {
        together.add(claimed);
      }
    }
    JointRenewal.renew(together, scheduler);
  }

  /** Gives the lease to a call of another renewer, if it is due soon; null if it is not. */
  private synchronized @Nullable DueLease claim() {
    if (closed || busy || next == null || isOver() || nanosUntilDue() > periodNanos / 2) {
      return null;
    }
    next.cancel();
    busy = true;
    return new DueLease(this, lease, duration);
  }

  /** As {@link #conclude}; whatever a foreign exception does, the lease is renewed again. */
  void tryConclude(Lease held, long begun, @Nullable Exception failure) {
    try {
      conclude(held, begun, failure);
    } catch (RuntimeException e) {
      LOG.log(Level.WARNING, what + ": the result of a renewal cannot be used", e);
      scheduleNext();
    }
  }

  /** Takes the result of a call that should have renewed the lease; null if it did. */
  private void conclude(Lease held, long begun, @Nullable Exception failure) {
    if (failure == null) {
      extended(held, begun);
      reached();
      scheduleNext();
    } else if (failure instanceof LeaseRevokedException e) {
      revoked(e);
    } else if (isGone(failure)) {
      LOG.log(Level.DEBUG, () -> what + ": the lease is gone: " + failure);
      dispatch(() -> inContext(this::registerAgain)); // others of the same call do not wait
    } else {
      missed(failure);
      scheduleNext();
    }
  }

  /** Whether the lease has certainly ended, or the server that granted it has. */
  private boolean isGone(Exception failure) {
    if (failure instanceof java.rmi.ConnectException
        || failure instanceof java.rmi.ConnectIOException) {
      return comesBack && ConnectionRefusal.isProvenBy((RemoteException) failure);
    }
    return failure instanceof LeaseException || failure instanceof java.rmi.NoSuchObjectException;
  }

  private void registerAgain() {
    try {
      long asked = scheduler.nanos();
      replace(registration.register(), asked);
      reached();
    } catch (LeaseRevokedException e) {
      revoked(e);
    } catch (RemoteException | LeaseRefusedException | RuntimeException e) {
      missed(e);
    } finally {
      scheduleNext();
    }
  }

  private synchronized void extended(Lease renewed, long begun) {
    long granted = grantedNanos(renewed);
    leastGranted = Math.min(leastGranted, granted);
    end = begun + granted;
    if (isProven && provenAt + leastGranted - end > 0) {
      end = provenAt + leastGranted;
    }
  }

  private void replace(Lease fresh, long asked) {
    boolean tooLate;
    synchronized (this) {
      tooLate = closed;
      if (!tooLate) {
        HeldLeaseRegistry.remove(lease);
        HeldLeaseRegistry.add(fresh);
        RenewalGroups.SHARED.leave(this);
        RenewalGroups.SHARED.join(this, fresh);
        lease = fresh;
        leastGranted = grantedNanos(fresh);
        end = asked + leastGranted;
        isProven = false;
      }
    }
    if (tooLate) {
      cancelLease(fresh);
    } else {
      LOG.log(Level.INFO, () -> what + ": registered again");
    }
  }

  private synchronized void revoked(LeaseRevokedException e) {
    if (!closed) {
      closed = true;
      HeldLeaseRegistry.remove(lease);
      RenewalGroups.SHARED.leave(this);
      LOG.log(Level.INFO, () -> what + ": ended: " + e.getMessage());
    }
  }

  private synchronized void reached() {
    if (interruptedSince != null) {
      Duration gap = Duration.ofNanos(scheduler.nanos() - interruptedNanos);
      LOG.log(Level.INFO, () -> what + ": back after " + gap);
      interruptedSince = null;
    }
  }

  private synchronized void missed(Exception e) {
    if (interruptedSince == null && !closed) {
      interruptedSince = Instant.now();
      interruptedNanos = scheduler.nanos();
      justMissed = true;
      LOG.log(Level.WARNING, () -> what + ": interrupted, trying again until it is closed: " + e);
    }
  }

  private void cancelLease(Lease last) {
    try {
      last.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      LOG.log(Level.DEBUG, () -> what + ": the lease ends by itself: " + e);
    }
  }
}
