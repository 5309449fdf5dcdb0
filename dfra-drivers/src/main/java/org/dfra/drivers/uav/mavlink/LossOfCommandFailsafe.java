package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.dfra.drivers.link.Ticker;
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
 * How a vehicle comes to rest when its commander is lost.
 *
 * <pre>
 *   NOT COMMANDED --a command--&gt; COMMANDED --commander lost--&gt; OWED --accepted--&gt; NOT COMMANDED
 *                                    ^                          |  ^
 *                                    +--------a command---------+  +-- every 2 s, until accepted
 * </pre>
 *
 * <ul>
 *   <li>in the air it holds its place
 *   <li>but a landing or a return that the commander has ordered goes on, since it ends at rest: a
 *       caller that lets go after {@code Land} must not find the craft hovering until its battery
 *       is empty
 *   <li>on the ground it is disarmed, by no force: an autopilot that flies after all refuses
 *   <li>what the vehicle does not accept, or what could not be sent since it was lost, is sent
 *       again every 2 s
 *   <li>a vehicle that was not commanded is left alone: it may be a pilot's
 * </ul>
 *
 * <p>Safe for use by several threads: commands and the coming to rest exclude each other. Past a
 * command that is held up in the link, {@link #triggerWithoutLocks} sends the rest without awaiting
 * an answer; {@link #trigger} follows when the command is over. An answer does not say which of the
 * two it answers, so the rest is done only when two were accepted.
 */
final class LossOfCommandFailsafe {

  private static final Duration AGAIN = Duration.ofSeconds(2);
  private static final String STOP_NAME = "coming to rest";

  /** How long a rest waits for each lock, real time. */
  private static final long PATIENCE_MILLIS = 50;

  private final VehicleState vehicleState;
  private final FlightCommandSequencer sequencer;
  private final Ticker ticker;

  /** Held while an order is begun, also while its write is held up; taken before the orders'. */
  private final ReentrantLock lock = new ReentrantLock();

  // written under lock
  private volatile @Nullable FlightCommand lastCommand; // the last command, unless refused
  private volatile boolean commanded;

  private volatile boolean isPending; // cleared under lock

  /** A rest was sent past a write, and its answer may be yet to come. */
  private volatile boolean isSentPast;

  private long triedNanos; // guarded by lock

  LossOfCommandFailsafe(VehicleState picture, FlightCommandSequencer orders, Ticker ticker) {
    this.vehicleState = picture;
    this.sequencer = orders;
    this.ticker = ticker;
  }

  /**
   * There is a command: no rest.
   *
   * @return false where there is no vehicle to give it to
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
   * There is no commander any more. Where a write of the reader is held up, the rest is sent past
   * that, and once more as soon as the reader goes on.
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

  /** False where a write seems to be held up. */
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
   * Sends the same, without the locks that a command holds which is held up in the link.
   *
   * @param isDue whether the next commander does not command yet
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
        isDue)) { // the answer to this is not to be taken for one to that
      isSentPast = true;
      FlightProcedures.steps(step, vehicle, null, null, 0).forEach(connection::sendNow);
    }
  }

  /** It lands, or flies home to land there. */
  private boolean isEndingByItself(Vehicle vehicle) {
    @Nullable FlightCommand last = lastCommand;
    return last instanceof Land
        || last instanceof ReturnToLaunch
        || vehicleState.isInMode(FlightMode.LAND, vehicle)
        || vehicleState.isInMode(FlightMode.RETURN, vehicle);
  }

  /**
   * Tries again what was not accepted; called again and again, by the reader. Does not wait where a
   * command is being given: whoever closes the link, which may set a command free that is held up,
   * waits for the reader.
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

  /** An order has ended. */
  void ended(String commandName, CommandResult result, boolean isAlone) {
    lock.lock();
    try {
      if (commandName.equals(STOP_NAME)) {
        if (result.isAccepted() && isSentPast) {
          isSentPast = false; // this may be its answer; what follows it is to be accepted, too
        } else if (result.isAccepted() && isPending) {
          atRest();
        }
      } else if (!result.isAccepted()) {
        lastCommand = null;
        isPending |= isAlone && commanded; // its landing was refused after the commander had gone
      }
    } finally {
      lock.unlock();
    }
  }

  private void attempt(@Nullable MavlinkConnection connection) {
    triedNanos = ticker.nanos();
    @Nullable Vehicle vehicle = connection == null ? null : connection.vehicle();
    if (connection == null || vehicle == null || !vehicleState.isComplete()) {
      return; // it stays owed until there is a vehicle
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
