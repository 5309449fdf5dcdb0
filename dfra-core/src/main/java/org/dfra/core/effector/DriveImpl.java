package org.dfra.core.effector;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.DriveCommand;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.DriveState;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.DriveAttributes;
import org.dfra.persona.EffectorAttributes;

/**
 * Base of every driver of wheels or tracks. It limits velocities to the drive's maximum, and halts
 * the wheels on a command timeout or when the commander is lost. No driver can block the timer of
 * the timeout, and the halt runs on a separate thread of this module.
 *
 * <pre>
 *   stopped --velocity--&gt; moving --velocity--&gt; moving
 *   moving --zero velocity, command timeout, brake, commander lost--&gt; stopped
 * </pre>
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code max_speed}: metres per second; can be set while it runs, not above the drive's
 *       maximum
 *   <li>{@code max_yaw_rate}: radians per second; likewise
 *   <li>{@code command_timeout}: the command timeout: seconds without a new velocity after which
 *       the wheels are halted; at least {@value #MIN_COMMAND_TIMEOUT}, at most {@value
 *       DriveEffector#MAX_COMMAND_TIMEOUT} s minus the braking time; default {@value
 *       #DEFAULT_COMMAND_TIMEOUT}, or less if that is too long; can be set while it runs
 *   <li>{@code mount_frame} and so on: the pose of the drive's frame, see {@link
 *       org.dfra.core.module.DeviceImpl}
 * </ul>
 */
public abstract class DriveImpl extends EffectorImpl<DriveCommand> implements DriveEffector {

  static final double DEFAULT_COMMAND_TIMEOUT = 0.3;
  static final double MIN_COMMAND_TIMEOUT = 0.05;

  private static final double SLOWEST = 0.01;

  /**
   * The last command to the drive. Queries return this, so that no caller waits for a driver that
   * blocks.
   */
  private record Motion(Velocity velocity, boolean brake, long commandTimeouts) {

    static final Motion NONE = new Motion(Velocity.ZERO, false, 0);

    Motion at(Velocity now) {
      return new Motion(now, brake, commandTimeouts);
    }

    Motion braked(boolean set) {
      return new Motion(velocity, set, commandTimeouts);
    }

    Motion silenced() {
      return new Motion(velocity, brake, commandTimeouts + 1);
    }
  }

  private final DriveAttributes most;
  private final double mostSilence;
  private final CommandTimeout timeout;

  /**
   * Velocities other than zero, and the driver calls for them, are made only under the arbiter's
   * lock. The device's thread, which must not wait for that lock, may stop the wheels and set the
   * brake at any time.
   */
  private volatile Motion motion = Motion.NONE; // written with the lock changing held

  private final Object changing = new Object();

  /** Held while the state is published, so that the last published state is the newest. */
  private final Object publishLock = new Object();

  private volatile double maxSpeed;
  private volatile double maxYawRate;

  /**
   * See {@link EffectorImpl#EffectorImpl}.
   *
   * @param limits the limits of the drive, and the size of the robot
   * @param brakingTime seconds that the wheels need to stop from full speed, including the latency
   *     of the command; 0 to 0.45
   */
  protected DriveImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      DriveAttributes limits,
      double brakingTime,
      List<Precondition> preconditions) {
    super(
        context,
        description,
        author,
        version,
        List.of("Velocity", "Brake"),
        List.of("DriveState"),
        preconditions);
    this.most = limits;
    this.mostSilence =
        Math.floor((MAX_COMMAND_TIMEOUT - brakingTime) * 1e3 + 1e-6) / 1e3; // whole ms
    if (!(brakingTime >= 0 && mostSilence >= MIN_COMMAND_TIMEOUT)) {
      throw new IllegalArgumentException(
          path()
              + " needs "
              + brakingTime
              + " s to stop, more than "
              + (MAX_COMMAND_TIMEOUT - MIN_COMMAND_TIMEOUT)
              + " s; brake harder or drive slower");
    }
    double silence =
        settings()
            .number(
                "command_timeout",
                Math.min(DEFAULT_COMMAND_TIMEOUT, mostSilence),
                MIN_COMMAND_TIMEOUT,
                mostSilence);
    this.timeout = new CommandTimeout(context.robotTime(), haltExecutor(), silence, this::silent);
    declareLimits();
  }

  private void declareLimits() {
    maxSpeed = settings().number("max_speed", most.maxSpeed(), SLOWEST, most.maxSpeed());
    maxYawRate = settings().number("max_yaw_rate", most.maxYawRate(), SLOWEST, most.maxYawRate());
    parameterTable()
        .declareNumber(
            "max_speed",
            "velocities are limited to this",
            NumberRange.of(SLOWEST, most.maxSpeed(), "m/s"),
            () -> maxSpeed,
            value -> maxSpeed = value);
    parameterTable()
        .declareNumber(
            "max_yaw_rate",
            "velocities are limited to this",
            NumberRange.of(SLOWEST, most.maxYawRate(), "rad/s"),
            () -> maxYawRate,
            value -> maxYawRate = value);
    parameterTable()
        .declareNumber(
            "command_timeout",
            "without a new velocity for so long, the wheels are halted",
            NumberRange.of(MIN_COMMAND_TIMEOUT, mostSilence, "s"),
            () -> timeout.seconds(),
            value -> timeout.setSeconds(value));
  }

  /** Sends a velocity to the wheels, without repetition. Calls do not overlap; must not block. */
  protected abstract void setVelocity(Velocity wanted);

  /**
   * Stops the wheels as fast as the drive can; also called while there is no device. As {@link
   * #setVelocity}; must not throw. An emergency stop calls it even while another thread is blocked
   * in {@link #setVelocity}.
   */
  protected abstract void halt();

  /** Sets or releases the parking brake. As {@link #setVelocity}. */
  protected abstract void brake(boolean set);

  @Override
  protected final void execute(DriveCommand command) {
    haltIfLate(); // before any other command is executed, however busy the timer's threads are
    if (command instanceof Velocity wanted) {
      move(wanted);
    } else if (command instanceof Brake wanted) {
      park(wanted.engaged());
    }
    publishState();
  }

  private void move(Velocity wanted) {
    Velocity velocity = wanted.limitedTo(maxSpeed, maxYawRate);
    Motion before = change(last -> last.brake() ? last : last.at(velocity));
    if (before.brake() && !wanted.isZero()) {
      throw new BrakeEngagedException(
          path() + " has its brake set, and does not move until that is released");
    }
    try {
      if (velocity.isZero()) {
        timeout.cancel();
      } else {
        timeout.commandReceived();
      }
      setVelocity(velocity);
    } catch (RuntimeException | Error e) { // it may have been partly executed
      stand();
      throw e;
    }
    if (!velocity.isZero() && motion.velocity().isZero()) {
      stand(); // meanwhile the brake was set or the device was reset, perhaps before
    }
    haltIfLate(); // if the driver was blocked, do not wait for a timer
  }

  /** {@inheritDoc} A velocity that has waited for longer than its validity is refused. */
  @Override
  protected final long maxCommandAge(DriveCommand command) {
    return command instanceof Velocity wanted && !wanted.isZero()
        ? timeout.nanos()
        : Long.MAX_VALUE;
  }

  private void park(boolean set) {
    if (set) {
      stand();
    }
    brake(set);
    Motion unused = change(last -> last.braked(set));
  }

  /**
   * Handles a command timeout; on the halt thread. A driver that is blocked by a command is halted
   * during that command, and once more when it ends.
   */
  private void silent(long number) {
    commandArbiter().runBetweenCommands(() -> haltLate(number), () -> haltPastCommand(number));
  }

  private void haltLate(long number) {
    if (!timeout.isCurrent(number)) {
      return;
    }
    if (motion.velocity().isZero()) { // the device's thread stopped them
      timeout.cancel();
    } else if (timeout.isExpired()) {
      haltIfLate();
    } else { // a velocity was received meanwhile
      timeout.recheckLater(number);
    }
  }

  /**
   * Without the lock, which a blocked command holds. While commands are received, none is blocked.
   */
  private void haltPastCommand(long number) {
    if (timeout.isCurrent(number) && timeout.isExpired()) {
      haltDuringCommand();
    }
  }

  /** Halts the wheels if the last velocity is too old. Called between commands. */
  private void haltIfLate() {
    if (motion.velocity().isZero() || !timeout.isExpired()) {
      return;
    }
    Motion unused = change(Motion::silenced);
    stand();
    publishState();
    log.warn("{}: no velocity came for too long; the wheels are halted", path());
  }

  /** Returns the previous value. */
  private Motion change(UnaryOperator<Motion> how) {
    synchronized (changing) {
      Motion before = motion;
      motion = how.apply(before);
      return before;
    }
  }

  private void stand() {
    Motion unused = change(last -> last.at(Velocity.ZERO));
    timeout.cancel();
    halt();
  }

  @Override
  protected final void stopSafely() {
    stand();
    publishState();
  }

  /** {@inheritDoc} Without the lock: the blocked command holds it. */
  @Override
  protected final void stopDuringCommand() {
    halt();
  }

  /**
   * The device has lost its last command, since its link or its controller was reset: the wheels
   * are assumed to be stopped until the next velocity. Never waits for the driver; if the driver is
   * about to execute a velocity, it is halted afterwards.
   *
   * @param brakeSet whether its brake is set now
   */
  protected final void deviceReset(boolean brakeSet) {
    Motion unused = change(last -> last.at(Velocity.ZERO).braked(brakeSet));
    publishState();
  }

  /**
   * The device reports whether its brake is set. Others than the commander may set it, for example
   * by a switch on the robot. Braked wheels are halted, and do not resume when the brake is
   * released. Waits for the driver only briefly.
   */
  protected final void brakeReported(boolean set) {
    Motion last = change(was -> (set && !was.brake() ? was.at(Velocity.ZERO) : was).braked(set));
    if (last.brake() == set) {
      return;
    }
    publishState();
    if (set && !last.velocity().isZero()) {
      boolean unused =
          haltExecutor()
              .executeWithin(
                  () -> commandArbiter().runBetweenCommands(this::stand, this::haltDuringCommand),
                  DRIVER_TIMEOUT);
    }
  }

  private void publishState() {
    synchronized (publishLock) {
      publish(driveState());
    }
  }

  /** {@inheritDoc} Returns the cached state, also while the driver blocks. */
  @Override
  public final DriveState driveState() {
    Motion now = motion;
    return new DriveState(
        clock().instant(), now.velocity(), now.brake(), commander(), now.commandTimeouts());
  }

  /** Its attributes besides those of every drive; see {@link #deviceAttributes}. */
  protected List<? extends Attributes> driveAttributes() {
    return List.of();
  }

  @Override
  protected final List<? extends Attributes> deviceAttributes() {
    List<Attributes> all = new ArrayList<>();
    all.add(new EffectorAttributes(inputTypes(), null, surroundings()));
    all.add(new DriveAttributes(maxSpeed, maxYawRate, most.length(), most.width()));
    all.addAll(driveAttributes());
    return all;
  }

  /** The required conditions of the environment, a sentence each. */
  protected List<String> surroundings() {
    return List.of("The ground is firm and level.");
  }
}
