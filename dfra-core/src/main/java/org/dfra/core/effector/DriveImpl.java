package org.dfra.core.effector;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.DoubleSupplier;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.Range;
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
import org.dfra.time.Scheduler;
import org.dfra.time.Scheduler.Task;
import org.jspecify.annotations.Nullable;

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
 *       at least {@value #LEAST_SILENCE}, at most what the time for braking leaves of {@value
 *       DriveEffector#LONGEST_SILENCE} s; default {@value #USUAL_SILENCE}, or less where that is
 *       too long; can be set while it runs
 *   <li>{@code mount_frame} and so on: where the drive's frame stands, see {@link
 *       org.dfra.core.module.DeviceImpl}
 * </ul>
 */
public abstract class DriveImpl extends EffectorImpl<DriveCommand> implements DriveEffector {

  static final double USUAL_SILENCE = 0.3;
  static final double LEAST_SILENCE = 0.05;

  private static final double SLOWEST = 0.01;

  private final DriveAttributes most;
  private final double mostSilence;
  private final Scheduler scheduler;

  /** Runs nothing but this: see {@link Scheduler#commandTimer}. */
  private final Scheduler timer;

  /** Taken after the helm's lock, and before any of the driver's. */
  private final Object state = new Object();

  private double maxSpeed; // guarded by state
  private double maxTurnRate; // guarded by state
  private volatile double silence; // written under state
  private Velocity velocity = Velocity.ZERO; // guarded by state
  private boolean brake; // guarded by state
  private long silences; // guarded by state
  private volatile long lastNanos; // written under state; when the last velocity came

  private @Nullable Task watch; // guarded by state; the first of those with the same number

  /** Written under state. A watch that has not this number does nothing. */
  private final AtomicLong watches = new AtomicLong();

  /**
   * See {@link EffectorImpl#EffectorImpl}.
   *
   * @param most what the drive can do, and how large the robot is
   * @param braking seconds that the fastest wheels need to stand once they are to be halted, the
   *     way of the command included; 0 to 0.45
   */
  protected DriveImpl(
      ModuleContext context,
      String description,
      String author,
      String version,
      DriveAttributes most,
      double braking,
      List<Precondition> preconditions) {
    super(
        context,
        description,
        author,
        version,
        List.of("Velocity", "Brake"),
        List.of("DriveState"),
        preconditions);
    this.most = most;
    this.mostSilence = Math.floor((LONGEST_SILENCE - braking) * 1e3 + 1e-6) / 1e3; // whole ms
    this.scheduler = context.robotTime();
    this.timer = scheduler.commandTimer();
    if (!(braking >= 0 && mostSilence >= LEAST_SILENCE)) {
      throw new IllegalArgumentException(
          path()
              + " needs "
              + braking
              + " s to stand, more than "
              + (LONGEST_SILENCE - LEAST_SILENCE)
              + " s; brake harder or drive slower");
    }
    declareLimits();
  }

  private void declareLimits() {
    maxSpeed = settings().number("max_speed", most.maxSpeed(), SLOWEST, most.maxSpeed());
    maxTurnRate =
        settings().number("max_turn_rate", most.maxTurnRate(), SLOWEST, most.maxTurnRate());
    silence =
        settings()
            .number(
                "longest_silence",
                Math.min(USUAL_SILENCE, mostSilence),
                LEAST_SILENCE,
                mostSilence);
    declared()
        .number(
            "max_speed",
            "faster velocities are made slower",
            Range.of(SLOWEST, most.maxSpeed(), "m/s"),
            () -> locked(() -> maxSpeed),
            value -> locked(() -> maxSpeed = value));
    declared()
        .number(
            "max_turn_rate",
            "faster velocities are made slower",
            Range.of(SLOWEST, most.maxTurnRate(), "rad/s"),
            () -> locked(() -> maxTurnRate),
            value -> locked(() -> maxTurnRate = value));
    declared()
        .number(
            "longest_silence",
            "without a new velocity for so long, the wheels are halted",
            Range.of(LEAST_SILENCE, mostSilence, "s"),
            () -> locked(() -> silence),
            this::setSilence);
  }

  private double locked(DoubleSupplier access) {
    synchronized (state) {
      return access.getAsDouble();
    }
  }

  private void setSilence(double seconds) {
    synchronized (state) {
      silence = seconds;
      if (watch != null) {
        watchFor(silenceLeft());
      }
    }
  }

  /** Has the wheels turn so, not again by itself. Called one at a time; must not block. */
  protected abstract void turn(Velocity wanted);

  /**
   * Has the wheels stand, by the shortest way the drive knows; also while there is no device. As
   * {@link #turn}; must not throw. An emergency stop calls it even while another thread is held up
   * in {@link #turn}.
   */
  protected abstract void halt();

  /** Sets or releases the parking brake. As {@link #turn}. */
  protected abstract void brake(boolean set);

  @Override
  protected final void obey(DriveCommand command) {
    synchronized (state) {
      haltIfLate(); // before anything else is executed, however busy the timer's threads are
      if (command instanceof Velocity wanted) {
        move(wanted);
      } else if (command instanceof Brake wanted) {
        park(wanted.set());
      }
      tell(snapshot());
    }
  }

  private void move(Velocity wanted) {
    if (brake && !wanted.isZero()) {
      throw new BrakeEngagedException(
          path() + " has its brake set, and does not move until that is released");
    }
    velocity = wanted.within(maxSpeed, maxTurnRate);
    lastNanos = scheduler.nanos();
    if (velocity.isZero()) {
      forgetWatch();
    } else if (watch == null) {
      late().prepare();
      watchFor(silenceLeft());
    }
    try {
      turn(velocity);
    } catch (RuntimeException e) { // half of it may have been done
      stand();
      throw e;
    }
    haltIfLate(); // where the driver was held up, nobody waits for a timer
  }

  /** {@inheritDoc} A velocity that has waited for longer than it holds moves nothing any more. */
  @Override
  protected final long longestWait(DriveCommand command) {
    return command instanceof Velocity wanted && !wanted.isZero()
        ? Math.round(silence * 1e9)
        : Long.MAX_VALUE;
  }

  private void park(boolean set) {
    if (set) {
      stand();
    }
    brake(set);
    brake = set;
  }

  private long silenceLeft() {
    return Math.round(silence * 1e9) - (scheduler.nanos() - lastNanos);
  }

  private void watchFor(long nanos) {
    forgetWatch();
    watch = lookAfter(nanos, watches.get());
  }

  private Task lookAfter(long nanos, long number) {
    return timer.after(nanos, () -> late().execute(() -> look(number)));
  }

  private void forgetWatch() {
    watches.incrementAndGet();
    if (watch != null) {
      watch.cancel();
      watch = null;
    }
  }

  /**
   * Halts the wheels where the last velocity is too old; on this module's own thread. A driver that
   * is held up by a command is halted past that, and once more when that is over.
   */
  private void look(long number) {
    if (number != watches.get()) {
      return;
    }
    long left = silenceLeft();
    if (left > 0) { // a velocity has come since; without a lock, which a driver may have
      Task unused = lookAfter(left, number);
      return;
    }
    helm().betweenCommands(() -> haltLate(number), () -> haltPastCommand(number));
  }

  private void haltLate(long number) {
    synchronized (state) {
      if (number != watches.get()) {
        return;
      }
      if (silenceLeft() > 0) { // a velocity came meanwhile
        Task unused = lookAfter(silenceLeft(), number);
      } else {
        haltIfLate();
      }
    }
  }

  /** Without the lock, which whoever is held up has. Where commands flow, nobody is. */
  private void haltPastCommand(long number) {
    if (number != watches.get() || silenceLeft() > 0) {
      return;
    }
    try {
      halt();
    } catch (RuntimeException e) { // a driver's fault must not keep it from the halt that follows
      log.error("{}: it could not be halted while it is held up", path(), e);
    }
  }

  /** Halts the wheels where the last velocity is too old. Holds the lock. */
  private void haltIfLate() {
    if (velocity.isZero() || silenceLeft() > 0) {
      return;
    }
    silences++;
    stand();
    tell(snapshot());
    log.warn("{}: no velocity came for too long; the wheels are halted", path());
  }

  private void stand() {
    velocity = Velocity.ZERO;
    forgetWatch();
    halt();
  }

  @Override
  protected final void rest() {
    synchronized (state) {
      stand();
      tell(snapshot());
    }
  }

  /** {@inheritDoc} Without the lock: whoever is held up holds it. */
  @Override
  protected final void restMeanwhile() {
    halt();
  }

  /**
   * The device has forgotten what it was told, since its link or its controller was lost: the
   * wheels are taken to stand, and stay so until the next velocity.
   *
   * @param brakeSet whether its brake is set now
   */
  protected final void forgotten(boolean brakeSet) {
    synchronized (state) {
      velocity = Velocity.ZERO;
      forgetWatch();
      brake = brakeSet;
      tell(snapshot());
    }
  }

  /**
   * The device says whether its brake is set, which others than the commander may have done: a
   * switch on the robot, say. Wheels that are braked are not driven on when the brake is released.
   */
  protected final void brakeFound(boolean set) {
    synchronized (state) {
      if (brake == set) {
        return;
      }
      brake = set;
      if (set && !velocity.isZero()) {
        stand();
      }
      tell(snapshot());
    }
  }

  private DriveState snapshot() {
    return new DriveState(clock().instant(), velocity, brake, commander(), silences);
  }

  /** {@inheritDoc} It answers from memory. */
  @Override
  public final DriveState drive() {
    synchronized (state) {
      return snapshot();
    }
  }

  /** What it says of itself besides what every drive does; see {@link #traits}. */
  protected List<? extends Attributes> driveTraits() {
    return List.of();
  }

  @Override
  protected final List<? extends Attributes> traits() {
    List<Attributes> all = new ArrayList<>();
    all.add(new EffectorAttributes(inputTypes(), null, conditions()));
    synchronized (state) {
      all.add(new DriveAttributes(maxSpeed, maxTurnRate, most.length(), most.width()));
    }
    all.addAll(driveTraits());
    return all;
  }

  /** What the surroundings must be like, a sentence each. */
  protected List<String> conditions() {
    return List.of("The ground is firm and level.");
  }
}
