package org.dfra.core.behavior;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
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
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;

/**
 * Ties a behaviour's goal to what was true of the robot's wheels when somebody asked for it.
 *
 * <p>The parking brake is released here and nowhere else in a behaviour, only by {@link #prepare},
 * while somebody who knows that the robot may move asks for a goal or has it go on. A brake that is
 * set afterwards, by a person or by a controller that was switched off and on, is not released by a
 * new lease, the next leg or the next process.
 *
 * <p>An emergency stop ends a goal also where it was released before the goal came to command the
 * wheels again: {@link #requireNotStoppedSince} finds out whether the last stop is another one than
 * that of {@link #prepare}, or, where the wheels were not found then, whether it is younger.
 *
 * <p>Thread-safe.
 */
public final class DriveInterlock {

  private static final Duration LEASE = Duration.ofSeconds(2);

  /**
   * The drive's last stop or release before a goal.
   *
   * @param isKnown whether the drive was there to be asked
   * @param since when that was, by the drive's clock; null where there never was one, or it is not
   *     known
   * @param requested where it is not known: when the goal was asked for; null where that is not
   *     known either, so that any stop at all counts
   */
  public record LastStop(
      boolean isKnown, @Nullable Instant since, @Nullable MonotonicTimestamp requested) {

    /** Nothing is known; any stop at all counts. */
    public static final LastStop NOTHING = new LastStop(false, null, null);

    /** The drive was there, and was last stopped or released then; null for never. */
    public static LastStop known(@Nullable Instant since) {
      return new LastStop(true, since, null);
    }

    /** The drive was not there when the goal was asked for. */
    public static LastStop unknown(MonotonicTimestamp asked) {
      return new LastStop(false, null, asked);
    }

    /**
     * Whether the drive was stopped, or may have been.
     *
     * @param answered when it had answered, by this process's monotonic time, nanoseconds
     */
    private boolean isStoppedSince(EmergencyStopState now, long answered) {
      if (now.latched()) {
        return true;
      } else if (isKnown) {
        return !Objects.equals(now.since(), since);
      } else if (now.since() == null) {
        return false;
      }
      // The drive's clock may be another computer's, and both are set; spans are comparable.
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
   * @param context of the behaviour
   * @param drive the wheels that its goals move
   */
  DriveInterlock(ModuleContext context, ModuleDependency<DriveEffector> drive, Logger log) {
    this.path = context.path();
    this.context = context;
    this.drive = drive;
    this.log = log;
  }

  /** Gives the wheels that are there now. */
  public ModuleDependency<DriveEffector> drive() {
    return drive;
  }

  /**
   * A goal begins, or goes on because somebody asks for it. Where a program asks, and the drive is
   * not found yet, every stop from now on counts.
   *
   * @param isAttended whether the brake may be released
   * @throws NotReadyException if the brake may be released, and the drive is not found or does not
   *     serve, so that nobody knows whether it is set; what was seen before still counts where it
   *     is not found
   */
  void prepare(boolean isAttended) throws RemoteException {
    DriveEffector wheels;
    try {
      wheels = drive.resolve();
    } catch (NotReadyException e) {
      if (isAttended) {
        throw e;
      }
      seen = LastStop.unknown(now());
      return;
    }
    seen = LastStop.known(wheels.emergencyStopState().since());
    if (!isAttended) {
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
    } catch (LeaseRefusedException | CommandRefusedException e) { // it is found set, and said so
      log.info("{}: the parking brake stays set: {}", path, e.getMessage());
    }
  }

  /** What the goal has found. */
  public LastStop lastStop() {
    return seen;
  }

  /**
   * What the same goal found in an earlier process. Where that is only when it was asked for, it
   * counts within the same boot, and any stop counts after another.
   */
  public void restore(LastStop earlier) {
    @Nullable MonotonicTimestamp asked = earlier.requested();
    seen = asked == null || asked.isSameBoot(now()) ? earlier : LastStop.NOTHING;
  }

  /**
   * Refuses where the wheels were stopped for an emergency since the goal was prepared, whether
   * that was released or not. Asked when a goal takes the command of the wheels, after it has it,
   * so that a later stop refuses the command itself.
   *
   * @throws CommandRefusedByEmergencyStopException if they were
   * @throws NotReadyException if the wheels are not there
   */
  public void requireNotStoppedSince() throws RemoteException {
    requireNotStoppedSince(drive.resolve());
  }

  /** The same of these wheels. */
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
