package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.Locale;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.drive.rflex.RflexMessage.SystemStatus;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * The battery of an ATRV-Jr, as its rFLEX controller measures it. It belongs to the same group as
 * the drive; see {@link RflexDriveImpl}.
 *
 * <p>Parameters, besides those of {@link RflexLinkHandle}, all of which can be set while it runs:
 *
 * <ul>
 *   <li>{@code status_period}: seconds from one reading to the next, 0.2 to 60; default 1
 *   <li>{@code voltage_offset}: volts to add to the controller's measurement, −5 to 5; default 1.2.
 *       Measure it once with a voltmeter
 *   <li>{@code charge_curve}: remaining charge by voltage, {@code volts:share volts:share ...};
 *       default two 12 V lead-acid batteries in series, without load
 *   <li>{@code min_voltage}: volts, below which the test {@code voltage} fails; default 23
 * </ul>
 *
 * <p>The remaining charge is estimated from the voltage. The estimate is too low while the motors
 * draw current, which the controller does not measure.
 *
 * <p>The module is INITIALIZING until the first status, and again when the link is lost. A reading
 * is served for three periods and 2 s.
 *
 * <p>Tests: {@code link}, {@code readings}, {@code voltage}; recovery: {@code reopen_link}.
 * Threads: it owns none.
 */
public final class RflexBatteryImpl extends RflexSensorImpl<BatteryState> implements BatterySensor {

  private static final PeriodicReport STATUS =
      new PeriodicReport(
          RflexController.STATUS,
          "BatteryState",
          "its status",
          "its status has not been reported yet",
          "status_period",
          1,
          0.2,
          60);

  private volatile double offset;
  private volatile double least;
  private volatile ChargeCurve curve;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public RflexBatteryImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /** For tests: uses the given clock and source of links. */
  RflexBatteryImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(context, "battery of an ATRV-Jr, by an rFLEX controller", STATUS, ticker, source);
    this.offset = settings().number("voltage_offset", 1.2, -5, 5);
    this.least = settings().number("min_voltage", 23, 0, 60);
    this.curve = curve();
    diagnostics().addTest("voltage", link().arrivalCheck(RflexController.STATUS, this::voltage));
    declare();
  }

  private ChargeCurve curve() {
    return settings()
        .find("charge_curve")
        .map(
            text -> {
              try {
                return ChargeCurve.parse(text);
              } catch (IllegalArgumentException e) {
                throw settings().fault("charge_curve", String.valueOf(e.getMessage()), e);
              }
            })
        .orElse(ChargeCurve.LEAD_ACID_24);
  }

  private void declare() {
    parameterTable()
        .declareNumber(
            "voltage_offset",
            "at the battery above what the controller measures",
            NumberRange.of(-5, 5, "V"),
            () -> offset,
            value -> offset = value);
    parameterTable()
        .declareNumber(
            "min_voltage",
            "below it the test of the voltage fails",
            NumberRange.of(0, 60, "V"),
            () -> least,
            value -> least = value);
    parameterTable()
        .declareText(
            "charge_curve",
            "what is left at which voltage, volts:share",
            () -> curve.toString(),
            text -> curve = ChargeCurve.parse(text));
  }

  /**
   * {@inheritDoc}
   *
   * @throws NotReadyException if no reading has been received yet, or the last one has expired
   */
  @Override
  public BatteryState battery() {
    return latest().get();
  }

  @Override
  protected Duration longestAge() {
    return Duration.ofMillis(Math.round(3000 * period()) + 2000);
  }

  private DiagnosticFinding voltage() {
    @Nullable BatteryState reported = latest().peek();
    if (reported == null) {
      return new DiagnosticFinding(false, "no voltage has been reported yet");
    }
    double volts = reported.voltage();
    return volts >= least
        ? new DiagnosticFinding(true, plain(volts) + " V")
        : new DiagnosticFinding(
            false, plain(volts) + " V, less than " + plain(least) + " V; charge the battery");
  }

  private static String plain(double volts) {
    return String.format(Locale.ROOT, "%.2f", volts);
  }

  @Override
  Duration status() {
    return Duration.ofMillis(Math.round(period() * 1e3));
  }

  @Override
  void messageReceived(RflexMessage message) {
    if (message instanceof SystemStatus status) {
      double volts = Math.max(0, status.voltage() + offset);
      BatteryState now =
          new BatteryState(clock().instant(), volts, null, curve.remaining(volts), true);
      latest().set(now);
      publish(now);
    }
  }
}
