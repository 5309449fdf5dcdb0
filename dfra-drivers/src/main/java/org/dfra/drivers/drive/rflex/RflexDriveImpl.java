package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.SharedPort;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.drive.rflex.RflexMessage.SystemStatus;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.module.Precondition;
import org.dfra.module.Readiness;
import org.jspecify.annotations.Nullable;

/**
 * The wheels of an ATRV-Jr, by its rFLEX controller. Where odometry and battery of the same
 * controller are modules too, all of them are in one group and name the same {@code link}; see
 * {@link RflexController}.
 *
 * <p>Parameters, besides those of {@link DriveImpl} and {@link RflexPort}:
 *
 * <ul>
 *   <li>{@code units_per_metre}, {@code units_per_radian}: what the controller counts, 1000 to
 *       1000000, negative where it counts backwards or to the right; default 87462.73 and 36277.67
 *   <li>{@code acceleration}, {@code turn_acceleration}: m/s² and rad/s² by which it drives;
 *       default 1 and 2
 *   <li>{@code stop_deceleration}, {@code stop_turn_deceleration}: m/s² and rad/s² by which it
 *       stands; default 7 and 14. What they take from full speed limits {@code longest_silence}
 *   <li>{@code torque}, {@code turn_torque}: the most torque, in the controller's unit; default
 *       30000
 * </ul>
 *
 * <p>INITIALIZING until both axes were reported and the brake is known; again when the link is
 * lost. A velocity is told to the controller once, never again by itself. Only a halt is told again
 * while the wheels are reported to turn on, since a halt does no harm and its frame may be lost.
 *
 * <p>When the controller is switched on its brake is set. This driver never releases it by itself,
 * and no recovery does: the robot may stand on a slope, so that is for the commander. The brake is
 * known from the controller's status, once a second.
 *
 * <p>Tests, none of which moves the robot: {@code link}, {@code readings}, {@code brake}, {@code
 * voltage}. Recoveries: {@code reopen_link}; {@code reset_defaults}, which is refused while the
 * wheels turn.
 *
 * <p>Threads: it owns none; see {@link RflexController}.
 */
public final class RflexDriveImpl extends DriveImpl {

  /** The controller is not told of a range; this is what such electronics usually bears. */
  static final List<Precondition> PRECONDITIONS =
      List.of(new Precondition("temperature", 0, 40, "°C"));

  /** Slower is standing: 1 mm/s and 1 mrad/s. */
  private static final double STANDING = 1e-3;

  /** From a halt to the next, where the wheels turn on. */
  private static final Duration HALT_AGAIN = Duration.ofMillis(200);

  /** From a command to the brake until a status that contradicts it counts. */
  private static final Duration BRAKE_OBEYED = Duration.ofSeconds(2);

  private final Ticker ticker;
  private final RflexWheels wheels;
  private final RflexPort port;

  /** Taken after the base class' locks, and before none. */
  private final Object told = new Object();

  private boolean halted = true; // guarded by told
  private long haltedNanos; // guarded by told
  private @Nullable Boolean brakeTold; // guarded by told; null when the status is to be believed
  private long brakeNanos; // guarded by told

  // written by the reader
  private final Map<Axis, MotorReport> reports = new EnumMap<>(Axis.class);
  private volatile @Nullable SystemStatus status;
  private volatile boolean standing;
  private volatile String awaits = "it has not been started";

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public RflexDriveImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: by another time, and over links made in another way. */
  RflexDriveImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    this(context, ticker, source, RflexWheels.in(context.parameters()));
  }

  private RflexDriveImpl(
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source,
      RflexWheels wheels) {
    super(
        context,
        "wheels of an ATRV-Jr, by an rFLEX controller",
        "DFRA",
        "1.0",
        RflexWheels.ATRV_JR,
        wheels.braking(),
        PRECONDITIONS);
    this.ticker = ticker;
    this.wheels = wheels;
    this.port = new RflexPort(new Member(), context, ticker, source);
    port.declareIn(examinations(), declared());
    examinations()
        .test(
            "readings",
            port.next(
                RflexController.REPORT,
                () -> new Finding(true, "the controller reports both axes")));
    examinations().test("brake", port.next(RflexController.STATUS, this::brakeFinding));
    examinations().test("voltage", port.next(RflexController.STATUS, this::voltageFinding));
    examinations().recovery("reset_defaults", this::resetDefaults);
  }

  @Override
  protected void onStart() {
    awaits = "its link is being opened";
    port.start();
  }

  @Override
  protected void onClose() {
    port.close();
    awaits = "it has ended";
  }

  @Override
  protected String awaits() {
    return awaits;
  }

  @Override
  protected void turn(Velocity wanted) {
    if (wanted.isZero()) {
      halt();
      return;
    }
    RflexOutbox outbox = outbox();
    synchronized (told) {
      halted = false;
    }
    outbox.velocity(wheels.frame(Axis.TRANSLATION, wanted), wheels.frame(Axis.ROTATION, wanted));
  }

  private RflexOutbox outbox() {
    @Nullable RflexOutbox outbox = port.outbox();
    if (outbox == null) {
      throw new IllegalStateException(path() + " has ended");
    }
    return outbox;
  }

  @Override
  protected void halt() {
    synchronized (told) {
      halted = true;
      haltedNanos = ticker.nanos();
    }
    sendHalt();
  }

  private void sendHalt() {
    @Nullable RflexOutbox outbox = port.outbox();
    if (outbox != null) {
      outbox.halt(
          wheels.frame(Axis.TRANSLATION, Velocity.ZERO),
          wheels.frame(Axis.ROTATION, Velocity.ZERO));
    }
  }

  @Override
  protected void brake(boolean set) {
    RflexOutbox outbox = outbox();
    synchronized (told) {
      brakeTold = set;
      brakeNanos = ticker.nanos();
    }
    outbox.add(RflexCommands.brake(set));
    outbox.add(RflexCommands.status());
  }

  private Finding brakeFinding() {
    @Nullable SystemStatus now = status;
    return now == null
        ? new Finding(false, "the controller has not told its status yet")
        : new Finding(true, now.brakeSet() ? "the brake is set" : "the brake is released");
  }

  private Finding voltageFinding() {
    @Nullable SystemStatus now = status;
    return now == null || now.voltage() <= 0
        ? new Finding(false, "the controller measures no voltage; look at the battery's cable")
        : new Finding(true, "the controller measures " + now.voltage() + " V");
  }

  private Finding resetDefaults() throws Exception {
    return port.onOpen(
        controller -> {
          if (!drive().velocity().isZero() || !standing) {
            return new Finding(
                false, "the wheels turn, or are not known to stand; halt them first");
          }
          controller.outbox().add(RflexCommands.defaults());
          long before = controller.line().heard().sofar(RflexController.REPORT);
          return controller
                  .line()
                  .heard()
                  .await(RflexController.REPORT, before + 2, SharedPort.ANSWER)
              ? new Finding(true, "the controller has its defaults again, and reports")
              : new Finding(
                  false, "no report has come within " + LatestReading.seconds(SharedPort.ANSWER));
        });
  }

  /** On the reader thread. */
  private final class Member implements RflexMember {

    @Override
    public String path() {
      return RflexDriveImpl.this.path();
    }

    /** Whatever the controller was told before, now the wheels are to stand. */
    @Override
    public void opened() {
      awaits = "the link is open, axes and brake have not been told yet";
      reports.clear();
      status = null;
      sendHalt();
    }

    @Override
    public void heard(RflexMessage message) {
      if (message instanceof MotorReport report) {
        reports.put(report.axis(), report);
        standing = isStanding();
        haltAgain();
      } else if (message instanceof SystemStatus now) {
        status = now;
        believe(now.brakeSet());
      }
      if (readiness() == Readiness.INITIALIZING && status != null && reports.size() == 2) {
        become(Readiness.READY);
      }
    }

    private boolean isStanding() {
      @Nullable MotorReport along = reports.get(Axis.TRANSLATION);
      @Nullable MotorReport about = reports.get(Axis.ROTATION);
      return along != null
          && about != null
          && Math.abs(along.velocity() / wheels.perMetre()) < STANDING
          && Math.abs(about.velocity() / wheels.perRadian()) < STANDING;
    }

    private void haltAgain() {
      if (standing || reports.size() < 2) {
        return;
      }
      synchronized (told) {
        // Not after a velocity: under this lock it is either told already, or told after this.
        if (halted && ticker.nanos() - haltedNanos >= HALT_AGAIN.toNanos()) {
          haltedNanos = ticker.nanos();
          sendHalt();
        }
      }
    }

    @Override
    public void lost(String reason) {
      awaits = reason;
      standing = false;
      if (readiness().serves()) {
        become(Readiness.INITIALIZING, reason); // from here on nothing is obeyed
        forgotten(drive().brake());
      }
      synchronized (told) {
        halted = true;
        brakeTold = null;
      }
    }
  }

  /** A status that was under way when the brake was told something is older than that. */
  private void believe(boolean isSet) {
    synchronized (told) {
      Boolean wanted = brakeTold;
      if (wanted != null && wanted != isSet) {
        if (ticker.nanos() - brakeNanos < BRAKE_OBEYED.toNanos()) {
          return;
        }
        log.warn(
            "{}: its brake is {}, against what it was told", path(), isSet ? "set" : "released");
      }
      brakeTold = null;
    }
    brakeFound(isSet);
  }
}
