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
 * Base of every driver of wheels or tracks. It limits velocities to what the drive can, and halts
 * the wheels when the next velocity does not come in time or the commander is lost. The time-out is
 * a timer's that no driver can hold up, and the halt is on a thread of this module's own.
 *
 * <pre>
 *   standing --velocity--&gt; moving --velocity--&gt; moving
 *   moving --zero velocity, silence, brake, commander lost--&gt; standing
 * </pre>
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code max_speed}: metres per second; can be set while it runs, not above what the drive
 *       can
 *   <li>{@code max_turn_rate}: radians per second; likewise
 *   <li>{@code longest_silence}: seconds without a new velocity after which the wheels are halted;
 *       at least {@value #MIN_COMMAND_TIMEOUT}, at most what the time for braking leaves of {@value
 *       DriveEffector#MAX_COMMAND_TIMEOUT} s; default {@value #DEFAULT_COMMAND_TIMEOUT}, or less
 *       where that is too long; can be set while it runs
 *   <li>{@code mount_frame} and so on: where the drive's frame stands, see {@link
 *       org.dfra.core.module.DeviceImpl}
 * </ul>
 */
public abstract class DriveImpl extends EffectorImpl<DriveCommand> implements DriveEffector {

  static final double DEFAULT_COMMAND_TIMEOUT = 0.3;
  static final double MIN_COMMAND_TIMEOUT = 0.05;

  private static final double SLOWEST = 0.01;

  /**
   * What the drive was told last. Who asks gets this, so that nobody waits for a driver that is
   * held up.
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
   * Velocities other than zero, and the calls of the driver that go with them, are put under the
   * helm's lock alone. The device's thread, which must not wait for that, has wheels stand and
   * brakes set at any time.
   */
  private volatile Motion motion = Motion.NONE; // written under changing

  private final Object changing = new Object();

  /** Held while the state is told, so that the last one that is told is the newest. */
  private final Object publishLock = new Object();

  private volatile double maxSpeed;
  private volatile double maxYawRate;

  /**
   * See {@link EffectorImpl#EffectorImpl}.
   *
   * @param limits what the drive can do, and how large the robot is
   * @param brakingTime seconds that the fastest wheels need to stand once they are to be halted,
   *     the way of the command included; 0 to 0.45
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
              + " s to stand, more than "
              + (MAX_COMMAND_TIMEOUT - MIN_COMMAND_TIMEOUT)
              + " s; brake harder or drive slower");
    }
    double silence =
        settings()
            .number(
                "longest_silence",
                Math.min(DEFAULT_COMMAND_TIMEOUT, mostSilence),
                MIN_COMMAND_TIMEOUT,
                mostSilence);
    this.timeout = new CommandTimeout(context.robotTime(), haltExecutor(), silence, this::silent);
    declareLimits();
  }

  private void declareLimits() {
    maxSpeed = settings().number("max_speed", most.maxSpeed(), SLOWEST, most.maxSpeed());
    maxYawRate = settings().number("max_turn_rate", most.maxYawRate(), SLOWEST, most.maxYawRate());
    parameterTable()
        .declareNumber(
            "max_speed",
            "faster velocities are made slower",
            NumberRange.of(SLOWEST, most.maxSpeed(), "m/s"),
            () -> maxSpeed,
            value -> maxSpeed = value);
    parameterTable()
        .declareNumber(
            "max_turn_rate",
            "faster velocities are made slower",
            NumberRange.of(SLOWEST, most.maxYawRate(), "rad/s"),
            () -> maxYawRate,
            value -> maxYawRate = value);
    parameterTable()
        .declareNumber(
            "longest_silence",
            "without a new velocity for so long, the wheels are halted",
            NumberRange.of(MIN_COMMAND_TIMEOUT, mostSilence, "s"),
            () -> timeout.seconds(),
            value -> timeout.setSeconds(value));
  }

  /** Has the wheels turn so, not again by itself. Called one at a time; must not block. */
  protected abstract void setVelocity(Velocity wanted);

  /**
   * Has the wheels stand, by the shortest way the drive knows; also while there is no device. As
   * {@link #setVelocity}; must not throw. An emergency stop calls it even while another thread is
   * held up in {@link #setVelocity}.
   */
  protected abstract void halt();

  /** Sets or releases the parking brake. As {@link #setVelocity}. */
  protected abstract void brake(boolean set);

  @Override
  protected final void execute(DriveCommand command) {
    haltIfLate(); // before anything else is executed, however busy the timer's threads are
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
    } catch (RuntimeException | Error e) { // half of it may have been done
      stand();
      throw e;
    }
    if (!velocity.isZero() && motion.velocity().isZero()) {
      stand(); // meanwhile its brake was set, or it was forgotten: perhaps before it arrived
    }
    haltIfLate(); // where the driver was held up, nobody waits for a timer
  }

  /** {@inheritDoc} A velocity that has waited for longer than it holds moves nothing any more. */
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
   * The last velocity is too old; on the thread for halts. A driver that is held up by a command is
   * halted past that, and once more when that is over.
   */
  private void silent(long number) {
    commandArbiter().runBetweenCommands(() -> haltLate(number), () -> haltPastCommand(number));
  }

  private void haltLate(long number) {
    if (!timeout.isCurrent(number)) {
      return;
    }
    if (motion.velocity().isZero()) { // the device's thread had them stand
      timeout.cancel();
    } else if (timeout.isExpired()) {
      haltIfLate();
    } else { // a velocity came meanwhile
      timeout.recheckLater(number);
    }
  }

  /** Without the lock, which whoever is held up has. Where commands flow, nobody is. */
  private void haltPastCommand(long number) {
    if (timeout.isCurrent(number) && timeout.isExpired()) {
      haltDuringCommand();
    }
  }

  /** Halts the wheels where the last velocity is too old. Between commands. */
  private void haltIfLate() {
    if (motion.velocity().isZero() || !timeout.isExpired()) {
      return;
    }
    Motion unused = change(Motion::silenced);
    stand();
    publishState();
    log.warn("{}: no velocity came for too long; the wheels are halted", path());
  }

  /** Gives what it was before. */
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

  /** {@inheritDoc} Without the lock: whoever is held up holds it. */
  @Override
  protected final void stopDuringCommand() {
    halt();
  }

  /**
   * The device has forgotten what it was told, since its link or its controller was lost: the
   * wheels are taken to stand, and stay so until the next velocity. Never waits for the driver;
   * where that is about to execute a velocity, it is halted after it.
   *
   * @param brakeSet whether its brake is set now
   */
  protected final void deviceReset(boolean brakeSet) {
    Motion unused = change(last -> last.at(Velocity.ZERO).braked(brakeSet));
    publishState();
  }

  /**
   * The device says whether its brake is set, which others than the commander may have done: a
   * switch on the robot, say. Wheels that are braked are halted, and not driven on when the brake
   * is released. Waits for the driver for a moment at the most.
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

  /** {@inheritDoc} It answers from memory, also while the driver is held up. */
  @Override
  public final DriveState driveState() {
    Motion now = motion;
    return new DriveState(
        clock().instant(), now.velocity(), now.brake(), commander(), now.commandTimeouts());
  }

  /** What it says of itself besides what every drive does; see {@link #deviceAttributes}. */
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

  /** What the surroundings must be like, a sentence each. */
  protected List<String> surroundings() {
    return List.of("The ground is firm and level.");
  }
}
