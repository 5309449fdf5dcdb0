package org.dfra.drivers.uav.mavlink;

import java.time.Duration;
import java.util.function.Supplier;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Check;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable;
import org.dfra.drivers.device.SharedPort;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * A module's end of the {@link MavlinkConnection} that it shares with others.
 *
 * <p>Parameters that it reads: {@code link}, {@code vehicle}, {@code ground_station}, {@code
 * reopen_first}, {@code reopen_longest}. Parameters that it shows, besides those of {@link
 * SharedPort}, of all that shares the link: {@code autopilot}, {@code checksum_errors}, {@code
 * lost_frames}. Tests: {@code link}, {@code identification}; recovery: {@code reopen_link}.
 */
final class MavlinkPort extends SharedPort<MavlinkMember, MavlinkConnection> {

  /**
   * @param source opens the link; null to go by the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  MavlinkPort(
      MavlinkMember member,
      ModuleContext context,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    this(member, context, MavlinkSettings.of(context.parameters()), ticker, source);
  }

  private MavlinkPort(
      MavlinkMember member,
      ModuleContext context,
      MavlinkSettings settings,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(member, each -> MavlinkConnection.join(each, context, settings, ticker, source));
  }

  @Override
  public void declareIn(Examinations examinations, ParameterTable table) {
    super.declareIn(examinations, table);
    examinations.test("identification", () -> onOpen(MavlinkPort::identification));
    table.show("autopilot", "what flies, as it tells", this::autopilot);
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

  /** What flies, in words. */
  private String autopilot() {
    @Nullable MavlinkConnection now = joined();
    @Nullable Vehicle vehicle = now == null ? null : now.vehicle();
    if (now == null || vehicle == null) {
      return "none heard";
    }
    String version = now.software();
    return version == null ? vehicle.toString() : vehicle + ", software " + version;
  }

  /** One more has come, for {@link #next}. */
  void count(String what) {
    @Nullable MavlinkConnection now = joined();
    if (now != null) {
      now.line().heard().count(what);
    }
  }

  /**
   * The check whether another one comes.
   *
   * @param what is counted: a message's name, or by {@link #count}
   * @param name what it is, for people
   */
  Check next(String what, String name, Supplier<Duration> patience) {
    return next(what, name, patience, () -> new Finding(true, "the autopilot sends " + name));
  }

  private static Finding identification(MavlinkConnection connection) throws InterruptedException {
    if (connection.vehicle() == null) {
      return new Finding(false, "the link is open, but no autopilot is heard on it");
    }
    long before = connection.line().heard().sofar("AUTOPILOT_VERSION");
    connection.askForVersion();
    return connection.line().heard().await("AUTOPILOT_VERSION", before, ANSWER)
        ? new Finding(
            true, "it says it is " + connection.vehicle() + ", software " + connection.software())
        : new Finding(
            false,
            "it has not answered REQUEST_MESSAGE with AUTOPILOT_VERSION within "
                + LatestReading.seconds(ANSWER));
  }
}
