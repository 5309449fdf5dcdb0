package org.dfra.river.phoenix;

import java.rmi.RemoteException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import net.jini.activation.ActivationGroup;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reports to the daemon when an object of this group is ready for the first time, so that it knows
 * a module that worked and died from one that dies before it is of any use.
 *
 * <p>Thread: one daemon, {@code group-readiness}, which runs while an object is not ready yet. A
 * report that cannot be made is made again a second later: phoenix may be starting anew.
 */
final class ReadinessReports {

  private static final Logger LOG = LoggerFactory.getLogger(ReadinessReports.class);

  private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long AGAIN_NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Map<ActivationID, BooleanSupplier> awaited = new ConcurrentHashMap<>();
  private @Nullable Thread thread; // guarded by this

  /** An object was made. */
  void made(ActivationID id, Object object) {
    awaited.put(id, object instanceof ReadinessSource source ? source::isReady : () -> true);
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

  /** An object is active no longer. */
  void inactive(ActivationID id) {
    awaited.remove(id);
  }

  private void run() {
    while (!isOver()) {
      boolean all = true;
      for (Map.Entry<ActivationID, BooleanSupplier> each : awaited.entrySet()) {
        if (isReady(each)) {
          all &= report(each.getKey());
        }
      }
      LockSupport.parkNanos(this, all ? LOOK_NANOS : AGAIN_NANOS);
    }
  }

  private static boolean isReady(Map.Entry<ActivationID, BooleanSupplier> object) {
    try {
      return object.getValue().getAsBoolean();
    } catch (RuntimeException e) { // a driver's own; the others are reported all the same
      LOG.debug("It is not known whether {} is ready.", object.getKey(), e);
      return false;
    }
  }

  private synchronized boolean isOver() {
    if (awaited.isEmpty()) {
      thread = null;
    }
    return thread == null;
  }

  /** Whether nothing is to be done again. */
  private boolean report(ActivationID id) {
    try {
      if (ActivationGroup.getSystem() instanceof ReadinessMonitor monitor) {
        monitor.ready(id, GroupVm.incarnation());
      }
    } catch (RemoteException e) {
      LOG.debug("The readiness of an object could not be reported; trying again.", e);
      return false;
    } catch (ActivationException e) {
      LOG.debug("An object that is ready is not registered any more.", e);
    }
    awaited.remove(id);
    return true;
  }
}
