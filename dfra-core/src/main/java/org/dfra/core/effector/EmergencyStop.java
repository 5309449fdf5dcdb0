package org.dfra.core.effector;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.UUID;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lifecycle.Incident;
import org.jspecify.annotations.Nullable;

/**
 * Stops an effector, even if its driver blocks.
 *
 * <pre>
 *   latch (refuse all commands) --&gt; depose the commander --&gt; stop the driver
 *     --&gt; persist the latch --&gt; end the commander's lease
 * </pre>
 *
 * <p>A separate thread ({@code robot/name stop}) stops the driver. It starts with an emergency stop
 * and ends when the driver has stopped: so a driver that blocks does not block the caller.
 */
final class EmergencyStop {

  /** Maximum wait of an emergency stop for the driver. */
  private static final Duration DRIVER_TIMEOUT = Duration.ofMillis(500);

  /** The effector's operations that it uses. */
  interface Actions {

    /** Stops the device, between commands; see {@link EffectorImpl#stopSafely}. */
    void stopSafely();

    /** See {@link EffectorImpl#stopDuringCommand}. */
    void stopDuringCommand();

    /** Records an incident in the history. */
    void recordIncident(Incident.Kind kind, String what);

    /** Ends the lease of a deposed commander. */
    void revoke(UUID lease);
  }

  private final String module;
  private final EmergencyStopLatch latch;
  private final CommandArbiter arbiter;
  private final Actions ends;

  private final Object halting = new Object();

  @GuardedBy("halting")
  private @Nullable Halt last;

  EmergencyStop(String module, EmergencyStopLatch latch, CommandArbiter arbiter, Actions ends) {
    this.module = module;
    this.latch = latch;
    this.arbiter = arbiter;
    this.ends = ends;
  }

  /** One stop of the driver. */
  private final class Halt implements Runnable {
    final CountDownLatch over = new CountDownLatch(1);
    boolean begun; // guarded by halting, which the compiler cannot check here
    volatile @Nullable String fault;

    @Override
    public void run() {
      try {
        arbiter.runBetweenCommands(this::stopEffector, ends::stopDuringCommand);
      } catch (RuntimeException | Error e) { // a driver's fault; the stop's state reports it
        fault = "its driver could not be stopped (" + e + "); switch it off by hand";
        ends.recordIncident(Incident.Kind.EXCEPTION, "stopped for an emergency, " + fault);
      } finally {
        over.countDown();
      }
    }

    private void stopEffector() {
      synchronized (halting) {
        begun = true; // a stop requested from now on requires another halt
      }
      arbiter.markStopped(); // by what follows
      ends.stopSafely();
    }

    @Nullable String fault() {
      return over.getCount() > 0
          ? "its driver is blocked, and stops as soon as it continues"
          : fault;
    }
  }

  /** See {@link org.dfra.flow.effector.Effector#emergencyStop}. */
  EmergencyStopState stop(@Nullable String by) {
    boolean isNew = latch.engage(by);
    @Nullable UUID lease = arbiter.revokeCommander();
    Halt halt = halt();
    if (isNew) {
      ends.recordIncident(
          Incident.Kind.EMERGENCY_STOP,
          "it was stopped for an emergency, by " + latch.state().requester());
    }
    boolean interrupted = await(halt);
    try {
      persist();
      if (lease != null) {
        ends.revoke(lease);
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
    return state();
  }

  private Halt halt() {
    Halt halt;
    synchronized (halting) {
      @Nullable Halt waiting = last;
      if (waiting != null && !waiting.begun) {
        return waiting;
      }
      halt = new Halt();
      last = halt;
    }
    Thread thread = new Thread(halt, module + " stop");
    thread.setDaemon(true);
    thread.setPriority(Thread.MAX_PRIORITY);
    try {
      thread.start();
    } catch (OutOfMemoryError e) { // no memory for another thread; use this one
      halt.run();
    }
    return halt;
  }

  /** Whether the thread was interrupted; that must not prevent the write. */
  private static boolean await(Halt halt) {
    boolean interrupted = Thread.interrupted();
    try {
      boolean unused = halt.over.await(DRIVER_TIMEOUT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    return interrupted;
  }

  private void persist() {
    if (!latch.persist()) {
      ends.recordIncident(
          Incident.Kind.EXCEPTION,
          "of its emergency stop: " + String.valueOf(latch.state().fault()));
    }
  }

  /** See {@link org.dfra.flow.effector.Effector#releaseEmergencyStop}. */
  EmergencyStopState release(@Nullable String by) {
    if (latch.release(by)) {
      persist();
      ends.recordIncident(
          Incident.Kind.RELEASE,
          "it was released from its emergency stop, by " + latch.state().requester());
    }
    return state();
  }

  /** See {@link org.dfra.flow.effector.Effector#emergencyStopState}. */
  EmergencyStopState state() {
    EmergencyStopState stop = latch.state();
    @Nullable Halt halt;
    synchronized (halting) {
      halt = last;
    }
    @Nullable String fault = stop.latched() && halt != null ? halt.fault() : null;
    return fault == null ? stop : stop.withoutHalt(EmergencyStopLatch.join(fault, stop.fault()));
  }
}
