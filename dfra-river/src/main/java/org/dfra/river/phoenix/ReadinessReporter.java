package org.dfra.river.phoenix;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import net.jini.activation.ActivationGroup;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports to the daemon when an object of this group has worked: when it has been ready for as long
 * as the daemon's restart policy wants, without interruption. So the daemon knows a module that
 * worked and died from one that dies before it is of any use, and from one that was ready for a
 * moment and failed. Readiness is sampled: an interruption shorter than 0.1 s may pass unseen.
 *
 * <p>Thread: one daemon, {@code group-readiness}, which runs while an object has not worked yet. A
 * report that cannot be made is made again a second later: phoenix may be starting anew.
 */
final class ReadinessReporter {

  private static final Logger LOG = LoggerFactory.getLogger(ReadinessReporter.class);

  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long AGAIN_NANOS = TimeUnit.SECONDS.toNanos(1);

  /** Whom to report to. */
  interface MonitorSource {
    /** The monitor; null where the activation system is none. */
    @Nullable ReadinessMonitor monitor() throws ActivationException;
  }

  private final MonitorSource source;
  private final LongSupplier nanos;
  private final Map<ActivationID, TrackedObject> awaited = new ConcurrentHashMap<>();
  private @Nullable Thread thread; // guarded by this

  /** Reports of this virtual machine's group. */
  ReadinessReporter() {
    this(
        () -> ActivationGroup.getSystem() instanceof ReadinessMonitor monitor ? monitor : null,
        System::nanoTime);
  }

  /**
   * @param nanos monotonic time in nanoseconds
   */
  ReadinessReporter(MonitorSource source, LongSupplier nanos) {
    this.source = source;
    this.nanos = nanos;
  }

  /** An object that has not worked yet. Its fields are confined to whoever looks. */
  private static final class TrackedObject {
    private final BooleanSupplier isReady;
    private boolean wasReady;
    private long since; // nanos; means nothing unless wasReady

    TrackedObject(BooleanSupplier isReady) {
      this.isReady = isReady;
    }

    /** For how long it has been ready without interruption, in nanoseconds; −1 where it is not. */
    long readyFor(long now) {
      boolean isReadyNow = isReady.getAsBoolean();
      if (isReadyNow && !wasReady) {
        since = now;
      }
      wasReady = isReadyNow;
      return isReadyNow ? now - since : -1;
    }

    void lost() {
      wasReady = false;
    }
  }

  /** An object was made. */
  void made(ActivationID id, Object object) {
    track(id, object instanceof ReadinessSource source ? source::isReady : () -> true);
    synchronized (this) {
      if (thread == null) {
        thread = new Thread(this::run, "group-readiness");
        thread.setDaemon(true);
        try {
          thread.start();
        } catch (
            OutOfMemoryError e) { // no further thread; the next object that is made tries again
          thread = null;
          LOG.warn("The readiness of {} is not reported: {}", id, e.toString());
        }
      }
    }
  }

  /** An object that was made is looked at from now on. */
  void track(ActivationID id, BooleanSupplier isReady) {
    awaited.put(id, new TrackedObject(isReady));
  }

  /** An object is active no longer. */
  void inactive(ActivationID id) {
    awaited.remove(id);
  }

  private void run() {
    while (!isOver()) {
      LockSupport.parkNanos(this, poll() ? LOOK_NANOS : AGAIN_NANOS);
    }
  }

  private synchronized boolean isOver() {
    if (awaited.isEmpty()) {
      thread = null;
    }
    return thread == null;
  }

  /** Looks at each object once, and reports those that have worked; false where one failed. */
  boolean poll() {
    boolean all = true;
    for (Map.Entry<ActivationID, TrackedObject> each : awaited.entrySet()) {
      long readyFor = readyFor(each.getKey(), each.getValue());
      if (readyFor >= 0) {
        all &= report(each.getKey(), each.getValue(), readyFor);
      }
    }
    return all;
  }

  private long readyFor(ActivationID id, TrackedObject object) {
    try {
      return object.readyFor(nanos.getAsLong());
    } catch (RuntimeException e) { // a driver's own; the others are reported all the same
      LOG.debug("It is not known whether {} is ready.", id, e);
      object.lost();
      return -1;
    }
  }

  /** Whether nothing is to be done again. */
  private boolean report(ActivationID id, TrackedObject object, long readyFor) {
    try {
      @Nullable ReadinessMonitor monitor = source.monitor();
      if (monitor != null) {
        if (readyFor < TimeUnit.MILLISECONDS.toNanos(monitor.minReadyMillis())) {
          return true;
        }
        monitor.reportStable(id, GroupVm.incarnation());
      }
    } catch (RemoteException e) {
      LOG.debug("That an object has worked could not be reported; trying again.", e);
      return false;
    } catch (ActivationException e) {
      LOG.debug("An object that has worked is not registered any more.", e);
    }
    boolean unused = awaited.remove(id, object);
    return true;
  }
}
