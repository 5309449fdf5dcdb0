package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.module.NotReadyException;
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
 *   <li>read-only: {@code controller_restarts}, how often the controller restarted its counts
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
public final class RflexOdometryImpl extends RflexSensorImpl<Odometry> implements OdometrySensor {

  private static final PeriodicReport AXES =
      new PeriodicReport(
          RflexController.REPORT,
          "Odometry",
          "both axes",
          "both axes have not been reported yet",
          "report_period",
          0.1,
          0.02,
          0.3);

  private final String odom;
  private final String base;
  private final WheelOdometer count; // confined to the reader

  private volatile long restarts;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public RflexOdometryImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  RflexOdometryImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(context, "odometry of an ATRV-Jr, by an rFLEX controller", AXES, ticker, source);
    this.odom = context.robot() + "/odom";
    this.base = context.robot() + "/base_link";
    this.count =
        new WheelOdometer(
            RflexDriveSettings.countsPerMetre(settings()),
            RflexDriveSettings.countsPerRadian(settings()),
            RflexDriveSettings.ATRV_JR.maxSpeed(),
            RflexDriveSettings.ATRV_JR.maxYawRate());
    parameterTable()
        .declareReadOnly(
            "controller_restarts",
            "how often the controller's counters restarted",
            () -> Long.toString(restarts));
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if no reading has been received yet, or the last one has expired
   */
  @Override
  public Odometry odometry() {
    return latest().get();
  }

  @Override
  protected Duration longestAge() {
    return Duration.ofMillis(Math.max(500, Math.round(5000 * period())));
  }

  @Override
  Duration reports() {
    return Duration.ofNanos(Math.round(period() * 1e6) * 1000);
  }

  @Override
  void opened() {
    count.linkInterrupted();
  }

  @Override
  void messageReceived(RflexMessage message) {
    if (message instanceof MotorReport report) {
      boolean isNew = count.update(report);
      if (restarts != count.restarts()) {
        restarts = count.restarts();
        log.info("{}: the controller's counters restarted; the pose continues", path());
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
    latest().set(now);
    publish(now);
  }
}
