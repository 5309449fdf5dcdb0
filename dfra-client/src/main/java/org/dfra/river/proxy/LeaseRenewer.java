package org.dfra.river.proxy;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import net.jini.core.lease.Lease;
import net.jini.core.lease.LeaseDeniedException;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.river.call.CallThreads;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.remote.LeaseRevokedException;
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.ScheduledTask;
import org.jspecify.annotations.Nullable;

/**
 * Maintains a lease at a server until its owner closes it. It renews the lease, and requests a new
 * one if the server has lost it or was restarted.
 *
 * <p>It checks the lease every {@value #PERIOD_MILLIS} ms, more often if the lease is short, and
 * once more soon after the first failed call. All renewers of this virtual machine share one timer
 * thread, which only dispatches. Threads that exist during a call make the calls, so an
 * unresponsive server delays no other renewal. The lease's duration is measured in monotonic time:
 * a change of the system clock neither ends nor prolongs it. The timer references the renewer. It
 * ends when it is closed, when its lease was revoked, or when it has lost a lease that may not be
 * requested again.
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

  /** Starts to maintain the lease. */
  synchronized void start() {
    if (!closed) {
      HeldLeaseRegistry.add(lease);
      next =
          scheduler.after(
              justMissed ? Math.min(RETRY_NANOS, periodNanos) : periodNanos, this::send);
      justMissed = false;
    }
  }

  /** Called on the timer's thread: dispatches the check of the lease to another thread. */
  private void send() {
    try {
      callers.execute(this::look);
    } catch (OutOfMemoryError e) { // no further thread
      LOG.log(Level.WARNING, () -> what + ": no thread to renew it, trying again: " + e);
      start();
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
    return PendingLeaseCancellations.run(CALLERS, () -> cancelLease(last));
  }

  private void look() {
    Thread thread = Thread.currentThread();
    @Nullable ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(loader);
    try {
      lookAfterIt();
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
    try {
      long begun = scheduler.nanos();
      if (!over && renewed(held)) {
        extended(held, begun);
      } else {
        long asked = scheduler.nanos();
        replace(registration.register(), asked);
      }
      reached();
    } catch (LeaseRevokedException e) {
      revoked(e);
    } catch (RemoteException | LeaseRefusedException | RuntimeException e) {
      missed(e);
    } finally {
      start();
    }
  }

  /** Renews the lease; false if it has certainly ended, or the server that granted it has. */
  private boolean renewed(Lease held) throws RemoteException, LeaseRevokedException {
    try {
      held.renew(duration);
      return true;
    } catch (LeaseRevokedException e) {
      throw e;
    } catch (java.rmi.ConnectException | java.rmi.ConnectIOException e) {
      if (!comesBack || !ConnectionRefusal.isProvenBy(e)) {
        throw e; // it may yet be renewed
      }
      return gone(e);
    } catch (UnknownLeaseException | LeaseDeniedException | java.rmi.NoSuchObjectException e) {
      return gone(e);
    }
  }

  private boolean gone(Exception e) {
    LOG.log(Level.DEBUG, () -> what + ": the lease is gone: " + e);
    return false;
  }

  private synchronized void extended(Lease renewed, long begun) {
    end = begun + grantedNanos(renewed);
  }

  private void replace(Lease fresh, long asked) {
    boolean tooLate;
    synchronized (this) {
      tooLate = closed;
      if (!tooLate) {
        HeldLeaseRegistry.remove(lease);
        HeldLeaseRegistry.add(fresh);
        lease = fresh;
        end = asked + grantedNanos(fresh);
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
