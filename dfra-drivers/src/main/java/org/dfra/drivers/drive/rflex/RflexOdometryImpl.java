package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Wheel odometry of an ATRV-Jr, from its rFLEX controller. It belongs to the same group as the
 * drive; see {@link RflexDriveImpl}.
 *
 * <p>Parameters, besides those of {@link RflexLinkHandle}:
 *
 * <ul>
 *   <li>{@code units_per_metre}, {@code units_per_radian}: as in {@link RflexDriveImpl}; set the
 *       same values
 *   <li>{@code report_period}: seconds from one reading to the next, 0.02 to 0.3; default 0.1; can
 *       be set while it runs
 *   <li>read-only: {@code restarts}, how often the controller restarted its counts
 * </ul>
 *
 * <p>The pose is that of {@code robot/base_link} in {@code robot/odom}, whose origin is the robot's
 * pose when this module was started. When the controller is switched off and on, or the link is
 * lost, the pose continues from its last value; {@link WheelOdometer} explains how a restart is
 * detected.
 *
 * <p>The module is INITIALIZING until both axes have been reported, and again when the link is
 * lost. A reading is served for five periods, but at least half a second.
 *
 * <p>Tests: {@code link}, {@code readings}; recovery: {@code reopen_link}. Threads: it owns none.
 */
public final class RflexOdometryImpl extends SensorImpl implements OdometrySensor {

  private static final double SHORTEST = 0.02;
  private static final double LONGEST = 0.3;
  private static final double USUAL = 0.1;

  private final SensorAttributes sensor =
      new SensorAttributes(
          "Odometry", List.of("continuous"), 1 / LONGEST, 1 / SHORTEST, null, List.of());

  private final String odom;
  private final String base;
  private final LatestReading<Odometry> latest;
  private final RflexLinkHandle port;
  private final WheelOdometer count; // confined to the reader

  private volatile double period;
  private volatile long restarts;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public RflexOdometryImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  RflexOdometryImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "odometry of an ATRV-Jr, by an rFLEX controller",
        "DFRA",
        "1.0",
        List.of("Odometry"),
        RflexDriveImpl.PRECONDITIONS);
    this.odom = context.robot() + "/odom";
    this.base = context.robot() + "/base_link";
    this.latest =
        new LatestReading<>("reading", this, this::transitionTo, ticker::nanos, this::longestAge);
    this.count =
        new WheelOdometer(
            RflexDriveSettings.countsPerMetre(settings()),
            RflexDriveSettings.countsPerRadian(settings()),
            RflexDriveSettings.ATRV_JR.maxSpeed(),
            RflexDriveSettings.ATRV_JR.maxYawRate());
    this.period = settings().number("report_period", USUAL, SHORTEST, LONGEST);
    this.port = new RflexLinkHandle(new Member(), context, ticker, source);
    port.declareIn(diagnostics(), parameterTable());
    diagnostics()
        .addTest(
            "readings",
            port.arrivalCheck(
                RflexController.REPORT,
                () -> new DiagnosticFinding(true, "the controller reports both axes")));
    parameterTable()
        .declareNumber(
            "report_period",
            "from one reading to the next",
            NumberRange.of(SHORTEST, LONGEST, "s"),
            () -> period,
            value -> period = value);
    parameterTable()
        .declareReadOnly(
            "restarts",
            "how often the controller began to count anew",
            () -> Long.toString(restarts));
  }

  @Override
  protected void onStart() {
    latest.setMissing("its link is being opened");
    port.start();
  }

  @Override
  protected void onClose() {
    port.close();
    latest.clear("it has ended");
  }

  @Override
  public double updateRate() {
    return 1 / period;
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if no reading has been received yet, or the last one has expired
   */
  @Override
  public Odometry odometry() {
    return latest.get();
  }

  private Duration longestAge() {
    return Duration.ofMillis(Math.max(500, Math.round(5000 * period)));
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return List.of(sensor);
  }

  /** On the reader thread. */
  private final class Member implements RflexClient {

    @Override
    public String path() {
      return RflexOdometryImpl.this.path();
    }

    @Override
    public Duration reports() {
      return Duration.ofNanos(Math.round(period * 1e6) * 1000);
    }

    @Override
    public void opened() {
      latest.setMissing("the link is open, both axes have not been reported yet");
      count.linkInterrupted();
    }

    @Override
    public void messageReceived(RflexMessage message) {
      if (message instanceof MotorReport report) {
        boolean isNew = count.update(report);
        if (restarts != count.restarts()) {
          restarts = count.restarts();
          log.info("{}: the controller counts anew; the pose goes on from where it was", path());
        }
        if (isNew) {
          deliver();
        }
      }
    }

    private void deliver() {
      Odometry now =
          new Odometry(
              clock().instant(),
              odom,
              base,
              count.x(),
              count.y(),
              count.yaw(),
              count.speed(),
              count.yawRate());
      latest.set(now);
      publish(now);
    }

    @Override
    public void lost(String reason) {
      latest.markLost(reason);
    }
  }
}
