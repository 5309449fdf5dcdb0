package org.dfra.core.behavior;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import org.dfra.core.behavior.BehaviorImpl.RequestedBy;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleDependency;
import org.dfra.core.time.BootId;
import org.dfra.core.time.MonotonicTimestamp;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Binds a behaviour's goal to the state of the robot's wheels at the time of the request.
 *
 * <p>The parking brake is released here and nowhere else in a behaviour, only by {@link #prepare},
 * when an operator who knows that the robot may move requests or resumes a goal. A brake that is
 * set afterwards, by an operator or by a motor controller after a power cycle, is not released by a
 * new lease, the next leg or the next process.
 *
 * <p>An emergency stop ends a goal even if it was released before the goal commands the wheels
 * again: {@link #requireNotStoppedSince} checks whether the last stop differs from the one at
 * {@link #prepare}, or, if the drive was not found then, whether it is newer.
 *
 * <p>Thread-safe.
 */
public final class DriveInterlock {

  private static final Duration LEASE = Duration.ofSeconds(2);

  /**
   * The drive's last stop or release before a goal.
   *
   * @param isKnown whether the drive was reachable
   * @param since time of that stop or release, by the drive's clock; null if there was none, or it
   *     is unknown
   * @param requested if unknown: when the goal was requested; null if that is unknown too, so that
   *     any stop counts
   */
  public record LastStop(
      boolean isKnown, @Nullable Instant since, @Nullable MonotonicTimestamp requested) {

    /** Nothing is known; any stop counts. */
    public static final LastStop NOTHING = new LastStop(false, null, null);

    /** The drive was reachable, and was last stopped or released at this time; null for never. */
    public static LastStop known(@Nullable Instant since) {
      return new LastStop(true, since, null);
    }

    /** The drive was not reachable when the goal was requested. */
    public static LastStop unknown(MonotonicTimestamp asked) {
      return new LastStop(false, null, asked);
    }

    /**
     * Whether the drive was stopped, or may have been.
     *
     * @param answered when its answer arrived, by this process's monotonic clock, nanoseconds
     */
    private boolean isStoppedSince(EmergencyStopState now, long answered) {
      if (now.latched()) {
        return true;
      } else if (isKnown) {
        return !Objects.equals(now.since(), since);
      } else if (now.since() == null) {
        return false;
      }
      // The drive's clock may be another computer's, and clocks are set; durations are comparable.
      @Nullable Duration age = now.age();
      return requested == null || age == null || answered - age.toNanos() - requested.nanos() >= 0;
    }
  }

  private final String path;
  private final ModuleContext context;
  private final ModuleDependency<DriveEffector> drive;
  private final Logger log;
  private volatile LastStop seen = LastStop.NOTHING;

  /**
   * @param context the behaviour's context
   * @param drive the drive that its goals move
   */
  DriveInterlock(ModuleContext context, ModuleDependency<DriveEffector> drive, Logger log) {
    this.path = context.path();
    this.context = context;
    this.drive = drive;
    this.log = log;
  }

  /** Returns the currently available drive. */
  public ModuleDependency<DriveEffector> drive() {
    return drive;
  }

  /**
   * Called when a goal starts, or is resumed on request. If a program requests it, and the drive is
   * not found yet, every stop from now on counts.
   *
   * @param requester an operator, if the brake may be released
   * @throws NotReadyException if the brake may be released, and the drive is not found or not
   *     ready, so that the brake's state is unknown; if it is not found, the previously read state
   *     still counts
   */
  void prepare(RequestedBy requester) throws RemoteException {
    DriveEffector wheels;
    try {
      wheels = drive.resolve();
    } catch (NotReadyException e) {
      if (requester == RequestedBy.OPERATOR) {
        throw e;
      }
      seen = LastStop.unknown(now());
      return;
    }
    seen = LastStop.known(wheels.emergencyStopState().since());
    if (requester == RequestedBy.PROGRAM) {
      return;
    }
    Readiness readiness = wheels.readiness();
    if (!readiness.serves()) {
      throw new NotReadyException(
          "the drive of " + context.robot(),
          readiness,
          "whether its brake is set is not known; ask again when it serves");
    }
    if (wheels.driveState().parkingBrakeEngaged()) {
      release(wheels);
    }
  }

  private MonotonicTimestamp now() {
    return MonotonicTimestamp.now(BootId.system(), context.scheduler());
  }

  private void release(DriveEffector wheels) throws RemoteException {
    try (CommandLease lease = wheels.acquireCommandLease(LEASE)) {
      wheels.execute(lease.key(), new Brake(false));
      log.info("{}: the parking brake is released, since a goal is to be pursued", path);
    } catch (LeaseRefusedException | CommandRefusedException e) { // the next cycle reports it
      log.info("{}: the parking brake stays set: {}", path, e.getMessage());
    }
  }

  /** The last stop that {@link #prepare} read. */
  public LastStop lastStop() {
    return seen;
  }

  /**
   * Restores the value that an earlier process read for the same goal. If it is only the time of
   * the request, it is valid within the same boot; after a reboot any stop counts.
   */
  public void restore(LastStop earlier) {
    @Nullable MonotonicTimestamp asked = earlier.requested();
    seen = asked == null || asked.isSameBoot(now()) ? earlier : LastStop.NOTHING;
  }

  /**
   * Throws if the drive made an emergency stop since the goal was prepared, released or not. Call
   * it after acquiring the drive's command lease, so that a later stop refuses the command itself.
   *
   * @throws CommandRefusedByEmergencyStopException if it did
   * @throws NotReadyException if the drive is not available
   */
  public void requireNotStoppedSince() throws RemoteException {
    requireNotStoppedSince(drive.resolve());
  }

  /** The same for a given drive. */
  public void requireNotStoppedSince(DriveEffector wheels) throws RemoteException {
    EmergencyStopState now = wheels.emergencyStopState();
    if (seen.isStoppedSince(now, context.scheduler().nanos())) {
      throw new CommandRefusedByEmergencyStopException(
          path
              + ": its drive was stopped for an emergency after the goal was begun, "
              + now.inWords()
              + "; when it may move, ask for the goal again");
    }
  }
}
