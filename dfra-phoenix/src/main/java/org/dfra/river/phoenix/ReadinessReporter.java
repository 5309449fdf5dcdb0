package org.dfra.river.phoenix;

import com.google.errorprone.annotations.concurrent.GuardedBy;
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
 * Reports to the daemon when an object of this group is stable: ready without interruption for
 * {@code minReadyTime} of the daemon's restart policy. So the daemon distinguishes the crash of a
 * stable module from that of a module that fails during or shortly after its start. Readiness is
 * sampled: an interruption shorter than 0.1 s may be missed.
 *
 * <p>Thread: one daemon, {@code group-readiness}, which runs while an object is not yet stable. A
 * failed report is repeated a second later: phoenix may be restarting.
 */
final class ReadinessReporter {

  private static final Logger LOG = LoggerFactory.getLogger(ReadinessReporter.class);

  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long AGAIN_NANOS = TimeUnit.SECONDS.toNanos(1);

  /** Finds the receiver of the reports. */
  interface MonitorSource {
    /** The monitor; null if the activation system does not implement it. */
    @Nullable ReadinessMonitor monitor() throws ActivationException;
  }

  private final MonitorSource source;
  private final LongSupplier nanos;
  private final Map<ActivationID, TrackedObject> awaited = new ConcurrentHashMap<>();

  @GuardedBy("this")
  private @Nullable Thread thread;

  /** Creates a reporter of this virtual machine's group. */
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

  /** An object that is not yet stable. Only the polling thread uses its fields. */
  private static final class TrackedObject {
    private final BooleanSupplier isReady;
    private boolean wasReady;
    private long since; // nanos; meaningful only if wasReady

    TrackedObject(BooleanSupplier isReady) {
      this.isReady = isReady;
    }

    /** How long it has been ready without interruption, in nanoseconds; −1 if it is not ready. */
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

  /** Records that an object was instantiated. */
  void made(ActivationID id, Object object) {
    track(id, object instanceof ReadinessSource source ? source::isReady : () -> true);
    synchronized (this) {
      if (thread == null) {
        thread = new Thread(this::run, "group-readiness");
        thread.setDaemon(true);
        try {
          thread.start();
        } catch (OutOfMemoryError e) { // no further thread; the next instantiation retries
          thread = null;
          LOG.warn("The readiness of {} is not reported: {}", id, e.toString());
        }
      }
    }
  }

  /** Polls an object from now on. */
  void track(ActivationID id, BooleanSupplier isReady) {
    awaited.put(id, new TrackedObject(isReady));
  }

  /** Records that an object became inactive. */
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

  /** Polls each object once, and reports the stable ones; false if a report failed. */
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
    } catch (RuntimeException e) { // of a driver; the others are still reported
      LOG.debug("It is not known whether {} is ready.", id, e);
      object.lost();
      return -1;
    }
  }

  /** Reports a stable object; false if the report must be repeated. */
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
