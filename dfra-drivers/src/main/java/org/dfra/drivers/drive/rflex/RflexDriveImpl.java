package org.dfra.drivers.drive.rflex;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.core.effector.DriveImpl;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.SharedLinkHandle;
import org.dfra.drivers.drive.rflex.RflexController.RflexClient;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.drive.rflex.RflexMessage.SystemStatus;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Precondition;
import org.jspecify.annotations.Nullable;

/**
 * The drive of an ATRV-Jr, through its rFLEX controller. Where odometry and battery of the same
 * controller are modules too, all of them belong to one group and name the same {@code link}; see
 * {@link RflexController}.
 *
 * <p>Parameters, besides those of {@link DriveImpl} and {@link RflexLinkHandle}:
 *
 * <ul>
 *   <li>{@code units_per_metre}, {@code units_per_radian}: the controller's counts, 1000 to
 *       1000000, negative where it counts backwards or to the right; default 87462.73 and 36277.67
 *   <li>{@code acceleration}, {@code yaw_acceleration}: acceleration of the drive, m/s² and rad/s²;
 *       default 1 and 2
 *   <li>{@code stop_deceleration}, {@code stop_yaw_deceleration}: deceleration of a stop, m/s² and
 *       rad/s²; default 7 and 14. The stopping time from full speed limits {@code command_timeout}
 *   <li>{@code torque}, {@code yaw_torque}: maximum torque, in the controller's unit; default 30000
 * </ul>
 *
 * <p>The module is INITIALIZING until both axes have been reported and the state of the brake is
 * known, and again when the link is lost. A velocity is sent to the controller once and never
 * repeated. Only a halt is repeated while the controller reports that the wheels turn, because a
 * halt does no harm and its frame may be lost.
 *
 * <p>When the controller is switched on its brake is set. Neither this driver nor a recovery
 * releases it without a command, because the robot may be on a slope. The controller's status
 * reports the brake once a second.
 *
 * <p>Tests, none of which moves the robot: {@code link}, {@code readings}, {@code brake}, {@code
 * voltage}. Recoveries: {@code reopen_link}; {@code reset_defaults}, which is rejected while the
 * wheels turn.
 *
 * <p>Threads: it owns none; see {@link RflexController}.
 */
public final class RflexDriveImpl extends DriveImpl {

  /** No source states a range for the controller; this is typical for such electronics. */
  static final List<Precondition> PRECONDITIONS =
      List.of(new Precondition("temperature", 0, 40, "°C"));

  /** Maximum speed of a stopped robot: 1 mm/s and 1 mrad/s. */
  private static final double STOPPED_RATE = 1e-3;

  /** Period of halts while the wheels still turn. */
  private static final Duration HALT_AGAIN = Duration.ofMillis(200);

  /** Time after a brake command during which a contradicting status is ignored. */
  private static final Duration BRAKE_EXECUTED = Duration.ofSeconds(2);

  private final Ticker ticker;
  private final RflexDriveSettings wheels;
  private final RflexLinkHandle port;

  /** Acquired after the base class' locks; no other lock is acquired while it is held. */
  private final Object commandLock = new Object();

  @GuardedBy("commandLock")
  private boolean halted = true;

  @GuardedBy("commandLock")
  private long haltedNanos;

  // null when the reported status applies
  @GuardedBy("commandLock")
  private @Nullable Boolean commandedBrake;

  @GuardedBy("commandLock")
  private long brakeNanos;

  // written by the reader
  private final Map<Axis, MotorReport> reports = new EnumMap<>(Axis.class);
  private volatile @Nullable SystemStatus status;
  private volatile boolean stopped;
  private volatile String awaits = "it has not been started";

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public RflexDriveImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  RflexDriveImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    this(context, ticker, source, RflexDriveSettings.from(context.parameters()));
  }

  private RflexDriveImpl(
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source,
      RflexDriveSettings wheels) {
    super(
        context,
        "wheels of an ATRV-Jr, by an rFLEX controller",
        "DFRA",
        "1.0",
        RflexDriveSettings.ATRV_JR,
        wheels.braking(),
        PRECONDITIONS);
    this.ticker = ticker;
    this.wheels = wheels;
    this.port = new RflexLinkHandle(new Member(), context, ticker, source);
    port.declareIn(diagnostics(), parameterTable());
    diagnostics()
        .addTest(
            "readings",
            port.arrivalCheck(
                RflexController.REPORT,
                () -> new DiagnosticFinding(true, "the controller reports both axes")));
    diagnostics().addTest("brake", port.arrivalCheck(RflexController.STATUS, this::brakeFinding));
    diagnostics()
        .addTest("voltage", port.arrivalCheck(RflexController.STATUS, this::voltageFinding));
    diagnostics().addRecovery("reset_defaults", this::resetDefaults);
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
  protected String unavailableReason() {
    return awaits;
  }

  @Override
  protected void setVelocity(Velocity commanded) {
    if (commanded.isZero()) {
      halt();
      return;
    }
    RflexOutbox outbox = outbox();
    synchronized (commandLock) {
      halted = false;
    }
    outbox.velocity(
        wheels.frame(Axis.TRANSLATION, commanded), wheels.frame(Axis.ROTATION, commanded));
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
    synchronized (commandLock) {
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
    synchronized (commandLock) {
      commandedBrake = set;
      brakeNanos = ticker.nanos();
    }
    outbox.add(RflexCommands.brake(set));
    outbox.add(RflexCommands.status());
  }

  private DiagnosticFinding brakeFinding() {
    @Nullable SystemStatus now = status;
    return now == null
        ? new DiagnosticFinding(false, "the controller has not reported its status yet")
        : new DiagnosticFinding(
            true, now.brakeSet() ? "the brake is set" : "the brake is released");
  }

  private DiagnosticFinding voltageFinding() {
    @Nullable SystemStatus now = status;
    return now == null || now.voltage() <= 0
        ? new DiagnosticFinding(
            false, "the controller measures no voltage; look at the battery's cable")
        : new DiagnosticFinding(true, "the controller measures " + now.voltage() + " V");
  }

  private DiagnosticFinding resetDefaults() throws Exception {
    return port.runOnOpenLink(
        controller -> {
          if (!driveState().velocity().isZero() || !stopped) {
            return new DiagnosticFinding(
                false, "the wheels turn, or are not known to be stopped; halt them first");
          }
          controller.outbox().add(RflexCommands.defaults());
          long before = controller.deviceLink().eventCounter().total(RflexController.REPORT);
          return controller
                  .deviceLink()
                  .eventCounter()
                  .await(RflexController.REPORT, before + 2, SharedLinkHandle.ANSWER)
              ? new DiagnosticFinding(true, "the controller has its defaults again, and reports")
              : new DiagnosticFinding(
                  false,
                  "no report has come within " + LatestReading.seconds(SharedLinkHandle.ANSWER));
        });
  }

  /** On the reader thread. */
  private final class Member implements RflexClient {

    @Override
    public String path() {
      return RflexDriveImpl.this.path();
    }

    /** Stops the wheels, whatever was sent before. */
    @Override
    public void opened() {
      awaits = "the link is open, axes and brake have not been reported yet";
      reports.clear();
      status = null;
      sendHalt();
    }

    @Override
    public void messageReceived(RflexMessage message) {
      if (message instanceof MotorReport report) {
        reports.put(report.axis(), report);
        stopped = isStanding();
        haltAgain();
      } else if (message instanceof SystemStatus now) {
        status = now;
        believe(now.brakeSet());
      }
      if (readiness() == Readiness.INITIALIZING && status != null && reports.size() == 2) {
        transitionTo(Readiness.READY);
      }
    }

    private boolean isStanding() {
      @Nullable MotorReport along = reports.get(Axis.TRANSLATION);
      @Nullable MotorReport about = reports.get(Axis.ROTATION);
      return along != null
          && about != null
          && Math.abs(along.velocity() / wheels.countsPerMetre()) < STOPPED_RATE
          && Math.abs(about.velocity() / wheels.countsPerRadian()) < STOPPED_RATE;
    }

    private void haltAgain() {
      if (stopped || reports.size() < 2) {
        return;
      }
      synchronized (commandLock) {
        // No halt follows a new velocity: velocities are sent under the same lock.
        if (halted && ticker.nanos() - haltedNanos >= HALT_AGAIN.toNanos()) {
          haltedNanos = ticker.nanos();
          sendHalt();
        }
      }
    }

    @Override
    public void lost(String reason) {
      awaits = reason;
      stopped = false;
      if (readiness().serves()) {
        transitionTo(Readiness.INITIALIZING, reason); // from here on no command is executed
        deviceReset(driveState().parkingBrakeEngaged());
      }
      synchronized (commandLock) {
        halted = true;
        commandedBrake = null;
      }
    }
  }

  /** Takes the reported brake, unless the status may be older than the last brake command. */
  private void believe(boolean isSet) {
    synchronized (commandLock) {
      Boolean commanded = commandedBrake;
      if (commanded != null && commanded != isSet) {
        if (ticker.nanos() - brakeNanos < BRAKE_EXECUTED.toNanos()) {
          return;
        }
        log.warn(
            "{}: its brake is {}, unlike the last command", path(), isSet ? "set" : "released");
      }
      commandedBrake = null;
    }
    brakeReported(isSet);
  }
}
