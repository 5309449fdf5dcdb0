package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.VehicleState.FlightMode;
import org.dfra.flow.effector.FlightCommand;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.Disarm;
import org.dfra.flow.effector.FlightCommand.Hold;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightCommand.ReturnToLaunch;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState.Phase;
import org.jspecify.annotations.Nullable;

/**
 * Stops a vehicle safely when its commander is lost.
 *
 * <pre>
 *   NOT COMMANDED --a command--&gt; COMMANDED -commander lost-&gt; PENDING -accepted-&gt; NOT COMMANDED
 *                                    ^                         |  ^
 *                                    +--------a command--------+  +-- every 2 s, until accepted
 * </pre>
 *
 * <ul>
 *   <li>in the air it holds its position
 *   <li>but a commanded landing or return continues, because it ends on the ground: if the caller
 *       releases its lease after {@code Land}, the craft must not hover until its battery is empty
 *   <li>on the ground it is disarmed, without force: an autopilot that is in fact flying rejects
 *       this
 *   <li>a stop command that the vehicle does not accept, or that could not be sent because the link
 *       was lost, is resent every 2 s
 *   <li>a vehicle that was not commanded is not affected: a pilot may control it
 * </ul>
 *
 * <p>Safe for use by several threads: commands and stops exclude each other. If a command is
 * blocked in the link, {@link #triggerWithoutLocks} bypasses it and sends the stop command without
 * waiting for an answer; {@link #trigger} follows when the blocked command has ended. An
 * acknowledgement does not tell the two apart, so the stop is complete only when two have been
 * accepted.
 */
final class LossOfCommandFailsafe {

  private static final Duration AGAIN = Duration.ofSeconds(2);
  private static final String STOP_NAME = "coming to rest";

  /** How long a stop waits for each lock, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final VehicleState vehicleState;
  private final FlightCommandSequencer sequencer;
  private final Ticker ticker;

  /**
   * Held while a command is started, even if its write is blocked; acquired before the sequencer's
   * lock.
   */
  private final ReentrantLock lock = new ReentrantLock();

  // written under lock
  private volatile @Nullable FlightCommand lastCommand; // the last command, unless rejected
  private volatile boolean commanded;

  private volatile boolean isPending; // cleared under lock

  /** A stop command bypassed a blocked write, and its acknowledgement may still arrive. */
  private volatile boolean isSentPast;

  private long triedNanos; // guarded by lock

  LossOfCommandFailsafe(VehicleState picture, FlightCommandSequencer orders, Ticker ticker) {
    this.vehicleState = picture;
    this.sequencer = orders;
    this.ticker = ticker;
  }

  /**
   * Sends a command; cancels a pending stop.
   *
   * @return false if there is no vehicle
   */
  boolean sendCommand(
      FlightCommand command, List<MavlinkCommand> steps, MavlinkConnection connection) {
    lock.lock();
    try {
      isPending = false;
      commanded = true;
      lastCommand = command;
      return sequencer.start(command.getClass().getSimpleName(), steps, connection.commands());
    } finally {
      lock.unlock();
    }
  }

  /**
   * The commander is lost. If a write of the reader is blocked, the stop command bypasses it, and
   * is repeated when the reader continues.
   */
  void trigger(@Nullable MavlinkConnection connection) {
    if (!commanded) {
      return;
    }
    isPending = true;
    if (!tryTrigger(connection)) {
      triggerWithoutLocks(connection, () -> true);
    }
  }

  /** False if a write seems to be blocked. */
  private boolean tryTrigger(@Nullable MavlinkConnection connection) {
    if (!CommandProtocol.tryLock(lock, PATIENCE_MILLIS)) {
      return false;
    }
    try {
      if (connection != null) {
        return sequencer.tryRunExclusively(connection.commands(), () -> attempt(connection));
      }
      attempt(null);
      return true;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Sends the stop command without the locks, which a command that is blocked in the link may hold.
   *
   * @param isDue whether the next commander has not sent a command yet
   */
  void triggerWithoutLocks(@Nullable MavlinkConnection connection, BooleanSupplier isDue) {
    @Nullable Vehicle vehicle = connection == null ? null : connection.vehicle();
    if (!commanded || connection == null || vehicle == null || !vehicleState.isComplete()) {
      return;
    }
    if (vehicleState.phase() == Phase.ON_GROUND) {
      sendNow(new Disarm(), vehicle, connection, isDue);
    } else if (!isEndingByItself(vehicle)) {
      sendNow(new Hold(), vehicle, connection, isDue);
    }
  }

  private void sendNow(
      FlightCommand step, Vehicle vehicle, MavlinkConnection connection, BooleanSupplier isDue) {
    if (sequencer.tryCancelWithoutLock(
        isDue)) { // the acknowledgement of this must not count for the later one
      isSentPast = true;
      FlightProcedures.steps(step, vehicle, null, null, 0).forEach(connection::sendNow);
    }
  }

  /** Whether it is landing, or returning home to land. */
  private boolean isEndingByItself(Vehicle vehicle) {
    @Nullable FlightCommand last = lastCommand;
    return last instanceof Land
        || last instanceof ReturnToLaunch
        || vehicleState.isInMode(FlightMode.LAND, vehicle)
        || vehicleState.isInMode(FlightMode.RETURN, vehicle);
  }

  /**
   * Resends what was not accepted; called periodically by the reader. Does not wait for a command
   * that is being sent: closing the link, which may unblock that command, waits for the reader.
   */
  void retry(@Nullable MavlinkConnection connection) {
    if (!lock.tryLock()) {
      return;
    }
    try {
      if (isPending && ticker.nanos() - triedNanos >= AGAIN.toNanos()) {
        attempt(connection);
      }
    } finally {
      lock.unlock();
    }
  }

  /** A command has ended. */
  void ended(String commandName, CommandResult result, boolean isAlone) {
    lock.lock();
    try {
      if (commandName.equals(STOP_NAME)) {
        if (result.isAccepted() && isSentPast) {
          isSentPast = false; // this may be its acknowledgement; the next one must be accepted too
        } else if (result.isAccepted() && isPending) {
          atRest();
        }
      } else if (!result.isAccepted()) {
        lastCommand = null;
        isPending |= isAlone && commanded; // its landing was rejected after the commander was lost
      }
    } finally {
      lock.unlock();
    }
  }

  private void attempt(@Nullable MavlinkConnection connection) {
    triedNanos = ticker.nanos();
    @Nullable Vehicle vehicle = connection == null ? null : connection.vehicle();
    if (connection == null || vehicle == null || !vehicleState.isComplete()) {
      return; // it stays pending until there is a vehicle
    }
    FlightCommand step = new Hold();
    if (vehicleState.phase() == Phase.ON_GROUND) {
      if (!vehicleState.isArmed()
          && !(lastCommand instanceof Arm)
          && !(lastCommand instanceof TakeOff)) {
        sequencer.forget();
        atRest();
        return;
      }
      step = new Disarm();
    } else if (isEndingByItself(vehicle)) {
      isPending = false;
      return;
    }
    boolean unused =
        sequencer.start(
            STOP_NAME, FlightProcedures.steps(step, vehicle, null, null, 0), connection.commands());
  }

  private void atRest() {
    isPending = false;
    commanded = false;
    lastCommand = null;
  }
}
