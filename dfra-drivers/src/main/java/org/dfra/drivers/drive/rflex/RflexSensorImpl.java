package org.dfra.drivers.drive.rflex;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.drive.rflex.RflexController.RflexClient;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.persona.Attributes;
import org.dfra.persona.SensorAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Common base of the drivers of sensors that an rFLEX controller reports periodically.
 *
 * <p>Parameters, besides those of {@link RflexLinkHandle}: the period of {@link PeriodicReport},
 * which can be set while it runs. Tests: {@code link}, {@code readings}; recovery: {@code
 * reopen_link}. Threads: it owns none.
 *
 * @param <T> type of its readings; immutable
 */
abstract class RflexSensorImpl<T> extends LinkedSensorImpl<T> {

  /**
   * What the controller reports for this sensor.
   *
   * @param event counts its arrivals, see {@link RflexLinkHandle#arrivalCheck}
   * @param outputType the type of a reading, by the simple name of its class
   * @param content what is reported: {@code its status}
   * @param missing says that it is not there yet, as a clause
   * @param parameter name of the parameter for its period
   * @param usual default period, seconds
   * @param shortest shortest period, seconds
   * @param longest longest period, seconds
   */
  record PeriodicReport(
      String event,
      String outputType,
      String content,
      String missing,
      String parameter,
      double usual,
      double shortest,
      double longest) {}

  private final PeriodicReport report;
  private final SensorAttributes attributes;
  private final RflexLinkHandle port;

  private volatile double period;

  /**
   * See {@link org.dfra.core.module.SensorImpl}.
   *
   * @param source opens the link; null to use the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  RflexSensorImpl(
      ModuleContext context,
      String description,
      PeriodicReport report,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(
        context,
        description,
        List.of(report.outputType()),
        RflexDriveImpl.PRECONDITIONS,
        "reading",
        ticker);
    this.report = report;
    this.attributes =
        new SensorAttributes(
            report.outputType(),
            List.of("continuous"),
            1 / report.longest(),
            1 / report.shortest(),
            null,
            List.of());
    this.period =
        settings().number(report.parameter(), report.usual(), report.shortest(), report.longest());
    this.port = new RflexLinkHandle(new Member(), context, ticker, source);
    port.declareIn(diagnostics(), parameterTable());
    diagnostics()
        .addTest(
            "readings",
            port.arrivalCheck(
                report.event(),
                () -> new DiagnosticFinding(true, "the controller reports " + report.content())));
    parameterTable()
        .declareNumber(
            report.parameter(),
            "from one reading to the next",
            NumberRange.of(report.shortest(), report.longest(), "s"),
            () -> period,
            value -> period = value);
  }

  /** The controller has sent this message; on the reader thread. */
  abstract void messageReceived(RflexMessage message);

  /** The link has been opened; on the reader thread. */
  void opened() {}

  /** Required period of axis reports; queried repeatedly. */
  Duration reports() {
    return RflexClient.USUAL_REPORTS;
  }

  /** Required period of battery and brake reports; queried repeatedly. */
  Duration status() {
    return RflexClient.USUAL_STATUS;
  }

  /** Current time from one reading to the next, seconds. */
  final double period() {
    return period;
  }

  @Override
  protected final RflexLinkHandle link() {
    return port;
  }

  @Override
  public final double updateRate() {
    return 1 / period;
  }

  @Override
  protected final List<? extends Attributes> deviceAttributes() {
    return List.of(attributes);
  }

  /** On the reader thread. */
  private final class Member implements RflexClient {

    @Override
    public String path() {
      return RflexSensorImpl.this.path();
    }

    @Override
    public Duration reports() {
      return RflexSensorImpl.this.reports();
    }

    @Override
    public Duration status() {
      return RflexSensorImpl.this.status();
    }

    @Override
    public void opened() {
      latest().setMissing("the link is open, " + report.missing());
      RflexSensorImpl.this.opened();
    }

    @Override
    public void messageReceived(RflexMessage message) {
      RflexSensorImpl.this.messageReceived(message);
    }

    @Override
    public void lost(String reason) {
      latest().markLost(reason);
    }
  }
}
