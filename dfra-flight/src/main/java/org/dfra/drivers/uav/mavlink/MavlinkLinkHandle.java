package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.function.Supplier;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.Diagnostics.DiagnosticProcedure;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.device.SharedLinkHandle;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkKeeper.BackOff;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkConnection.MavlinkClient;
import org.jspecify.annotations.Nullable;

/**
 * A module's handle on the {@link MavlinkConnection} that it shares with others.
 *
 * <p>Parameters that it reads: {@code link}, {@code vehicle}, {@code ground_station}, {@code
 * reopen_initial_delay}, {@code reopen_max_delay}. Parameters that it publishes, besides those of
 * {@link SharedLinkHandle}, for the whole link: {@code autopilot}, {@code checksum_errors}, {@code
 * lost_frames}. Tests: {@code link}, {@code identification}; recovery: {@code reopen_link}.
 */
final class MavlinkLinkHandle extends SharedLinkHandle<MavlinkClient, MavlinkConnection> {

  /**
   * @param source opens the link; null to use the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  MavlinkLinkHandle(
      MavlinkClient client,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    this(client, context, MavlinkSettings.of(context.parameters()), ticker, source);
  }

  private MavlinkLinkHandle(
      MavlinkClient client,
      ModuleContext context,
      MavlinkSettings settings,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(client, each -> MavlinkConnection.join(each, context, settings, ticker, source));
  }

  @Override
  public void declareIn(Diagnostics examinations, ParameterTable table) {
    super.declareIn(examinations, table);
    examinations.addTest("identification", () -> runOnOpenLink(MavlinkLinkHandle::identification));
    table.declareReadOnly("autopilot", "the autopilot, as it reports itself", this::autopilot);
    show(
        table,
        "checksum_errors",
        "what looked like a frame but for its checksum so far",
        MavlinkConnection::checksumErrors);
    show(
        table,
        "lost_frames",
        "frames of the vehicle that did not arrive, or were not known, so far",
        MavlinkConnection::lostFrames);
  }

  /** Human-readable description of the autopilot. */
  private String autopilot() {
    @Nullable MavlinkConnection now = sharedLink();
    @Nullable Vehicle vehicle = now == null ? null : now.vehicle();
    if (now == null || vehicle == null) {
      return "none found";
    }
    String version = now.software();
    return version == null ? vehicle.toString() : vehicle + ", software " + version;
  }

  /** Counts an event, for {@link #arrivalCheck}. */
  void count(String event) {
    @Nullable MavlinkConnection now = sharedLink();
    if (now != null) {
      now.deviceLink().eventCounter().increment(event);
    }
  }

  /**
   * A test that passes when the next event arrives.
   *
   * @param event a message's name, or an event of {@link #count}
   * @param name human-readable name of the event
   */
  DiagnosticProcedure arrivalCheck(String event, String name, Supplier<Duration> timeout) {
    return arrivalCheck(
        event, name, timeout, () -> new DiagnosticFinding(true, "the autopilot sends " + name));
  }

  private static DiagnosticFinding identification(MavlinkConnection connection)
      throws InterruptedException {
    if (connection.vehicle() == null) {
      return new DiagnosticFinding(false, "the link is open, but no autopilot sends on it");
    }
    long before = connection.deviceLink().eventCounter().total("AUTOPILOT_VERSION");
    connection.askForVersion();
    return connection.deviceLink().eventCounter().await("AUTOPILOT_VERSION", before, ANSWER)
        ? new DiagnosticFinding(
            true, "it says it is " + connection.vehicle() + ", software " + connection.software())
        : new DiagnosticFinding(
            false,
            "it has not answered REQUEST_MESSAGE with AUTOPILOT_VERSION within "
                + LatestReading.seconds(ANSWER));
  }

  /**
   * The settings that must be the same in all modules that share a link.
   *
   * @param link its URL as configured
   * @param vehicle the number of the vehicle, 1 to 255; 0 is the first one received
   * @param groundStation system ID of this ground station, 1 to 255
   * @param backOff how long to wait before a lost link is reopened
   */
  record MavlinkSettings(String link, int vehicle, int groundStation, BackOff backOff) {

    /**
     * Reads {@code link}, {@code vehicle}, {@code ground_station}, {@code reopen_initial_delay} and
     * {@code reopen_max_delay}.
     *
     * @throws org.dfra.core.config.ConfigurationException if one is missing or wrong
     */
    static MavlinkSettings of(Parameters parameters) {
      return new MavlinkSettings(
          LinkSettings.address(parameters).toString(),
          whole(parameters, "vehicle", 0, 0),
          whole(parameters, "ground_station", 255, 1),
          LinkSettings.backOff(parameters));
    }

    private static int whole(Parameters parameters, String name, int fallback, int min) {
      double number = parameters.number(name, fallback, min, 255);
      if (number != Math.rint(number)) {
        throw parameters.fault(name, "a whole number from " + min + " to 255", null);
      }
      return (int) number;
    }
  }
}
