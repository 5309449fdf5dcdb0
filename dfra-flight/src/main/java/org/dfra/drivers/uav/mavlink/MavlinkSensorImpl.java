package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.NumberRange;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkConnection.MavlinkClient;
import org.dfra.module.Precondition;
import org.jspecify.annotations.Nullable;

/**
 * Common base of the drivers of sensors behind an autopilot.
 *
 * <p>Parameters, besides those of {@link MavlinkLinkHandle}: {@code period}, seconds from one
 * reading to the next, 0.05 to 60; default 1; can be set while it runs.
 *
 * <p>The module is INITIALIZING until the first reading, and again when the link or the vehicle is
 * lost, or when no reading has been received for three periods and 2 s. A reading is served for the
 * same time.
 *
 * <p>Tests: {@code link}, {@code identification}, {@code readings}; recovery: {@code reopen_link}.
 *
 * <p>Threads: it owns none; the shared {@link MavlinkConnection}'s reader does all the work.
 *
 * @param <T> type of its readings; immutable
 */
abstract class MavlinkSensorImpl<T> extends LinkedSensorImpl<T> {

  private final Ticker ticker;
  private final MavlinkLinkHandle port;
  private final String expected;

  private volatile double period;
  private long uselessNanos; // confined to the reader; when a message without a reading arrived

  /**
   * See {@link org.dfra.core.module.SensorImpl}.
   *
   * @param expected name of the message with its readings
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  MavlinkSensorImpl(
      ModuleContext context,
      String description,
      String expected,
      List<String> puts,
      List<Precondition> preconditions,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(context, description, puts, preconditions, "reading", ticker);
    this.ticker = ticker;
    this.uselessNanos = ticker.nanos() - Duration.ofDays(1).toNanos();
    this.expected = expected;
    this.period = settings().number("period", 1, 0.05, 60);
    this.port = new MavlinkLinkHandle(new Member(), context, ticker, source);
    port.declareIn(diagnostics(), parameterTable());
    diagnostics().addTest("readings", port.arrivalCheck(path(), expected, this::longestAge));
    parameterTable()
        .declareNumber(
            "period",
            "seconds from one reading to the next",
            NumberRange.of(0.05, 60, "s"),
            () -> period,
            value -> period = value);
  }

  /** The required messages, for a rate in hertz; queried repeatedly. */
  abstract Map<Integer, Double> messageRates(double rate);

  /** The vehicle's autopilot has sent this message; on the reader thread. */
  abstract void messageReceived(MavlinkMessage message);

  /** The source is lost: discards what is known of it. */
  void forget() {}

  /** A reading has been taken; on the reader thread. */
  final void markDelivered(T reading) {
    latest().set(reading);
    port.count(path());
  }

  /**
   * The message has been received, but contains no reading; on the reader thread.
   *
   * @param reason why, as a clause
   */
  final void reportUnusable(String reason) {
    uselessNanos = ticker.nanos();
    latest().setMissing(reason);
  }

  @Override
  protected final Duration longestAge() {
    return Duration.ofMillis(Math.round(3000 * period) + 2000);
  }

  @Override
  protected final MavlinkLinkHandle link() {
    return port;
  }

  @Override
  protected final void onClose() {
    super.onClose();
    forget();
  }

  /** {@inheritDoc} The currently configured rate. */
  @Override
  public final double updateRate() {
    return 1 / period;
  }

  private void withoutReading(String reason) {
    latest().markLost(reason);
    forget();
  }

  /** On the reader thread. */
  private final class Member implements MavlinkClient {

    @Override
    public String path() {
      return MavlinkSensorImpl.this.path();
    }

    @Override
    public Map<Integer, Double> messageRates() {
      return MavlinkSensorImpl.this.messageRates(updateRate());
    }

    @Override
    public void vehicleFound(Vehicle vehicle) {
      latest().setMissing(vehicle + " is connected, but has sent no " + expected + " yet");
    }

    @Override
    public void messageReceived(MavlinkMessage message) {
      MavlinkSensorImpl.this.messageReceived(message);
    }

    @Override
    public void periodic() {
      if (readiness().serves() && latest().isTooOld()) {
        boolean isUseless = ticker.nanos() - uselessNanos <= longestAge().toNanos();
        withoutReading(
            isUseless
                ? latest().missing()
                : "no " + expected + " for " + LatestReading.seconds(longestAge()));
      }
    }

    @Override
    public void lost(String reason) {
      withoutReading(reason);
    }
  }
}
