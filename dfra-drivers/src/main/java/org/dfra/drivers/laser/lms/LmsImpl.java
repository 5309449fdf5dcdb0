package org.dfra.drivers.laser.lms;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.laser.lms.LmsProtocol.LmsListener;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.jspecify.annotations.Nullable;

/**
 * SICK LMS 200 laser scanner, and related models with the same telegrams.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}, {@code reopen_initial_delay}, {@code reopen_max_delay}: see {@link
 *       LinkSettings}
 *   <li>{@code baud}: bits per second: 9600, 19200, 38400, 500000, or {@code keep} to use the
 *       link's current rate. Default 38400 on {@code serial:} and {@code sim:}, else {@code keep}:
 *       a serial server has its own rate, so set another value only for a server that follows the
 *       laser's rate
 *   <li>{@code field_of_view}: degrees, 180 (default) or 100; {@code resolution}: degrees, 0.5
 *       (default), 1, or 0.25 with field_of_view 100; both can be set while it runs
 *   <li>{@code units}: {@code mm} (default), {@code cm} or {@code keep}; {@code measuring_mode}: 0
 *       to 6, 15 or {@code keep} (default), see {@link MeasuringMode}. They are stored in the
 *       laser's flash memory, which is written only where it differs
 *   <li>{@code mode}: {@code continuous} (default) or {@code polled}, every {@code period} seconds,
 *       0.02 to 60, default 1; both can be set while it runs
 *   <li>{@code idle_timeout}: seconds without clients before scans are stopped, 0 to 3600, 0 is
 *       never; default 10; can be set while it runs
 *   <li>{@code mount_frame}, {@code mount_x} and so on: its pose, see {@link
 *       org.dfra.core.module.SensorImpl}
 *   <li>read-only: {@code status}, {@code flash_writes}, and those of {@link DeviceLink}
 * </ul>
 *
 * <p>The module is INITIALIZING until the first scan, and again when the link is lost, when the
 * laser does not answer, or when no scan has been received for three periods and 2 s. An idle laser
 * is READY but has no scan; the first client starts it, and so does {@link #scan}. For tests and
 * recoveries see {@link LmsDiagnostics}.
 *
 * <p>A scan's time is the arrival of its last byte minus the transmission time of its telegram and
 * the mirror's scan time; the laser's processing time is unknown and not included.
 *
 * <p>Threads: one reader ({@code name reader}), owned by a {@link DeviceLink} from {@code start} to
 * {@code close}, does all the work. Callers read immutable snapshots and never wait for the laser.
 */
public final class LmsImpl extends LinkedSensorImpl<RangeScan> implements RangeSensor {

  private final LmsSettings settings;
  private final LmsIdlePolicy idlePolicy;
  private final LmsProtocol protocol;
  private final DeviceLink deviceLink;
  private final LmsDiagnostics lmsDiagnostics;
  private final LmsPersona persona;

  // written by the reader, read by any thread
  private volatile Duration longestAge = Duration.ZERO; // of a scan, at the last scan's rate
  private volatile StatusByte health = StatusByte.OK;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public LmsImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /**
   * For tests: uses the given clock and source of links.
   *
   * @param source opens the link; null to use the parameter {@code link}
   */
  LmsImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "SICK LMS 200 scanning laser",
        List.of("RangeScan"),
        LmsDiagnostics.PRECONDITIONS,
        "scan",
        ticker);
    this.settings = LmsSettings.from(settings());
    this.idlePolicy = new LmsIdlePolicy(ticker, LmsSettings.idleAfterIn(settings()));
    this.persona = new LmsPersona(settings);
    Reader reader = new Reader();
    this.protocol = new LmsProtocol(settings, ticker, reader);
    this.deviceLink = new DeviceLink(context, protocol, ticker, source, log);
    this.lmsDiagnostics = new LmsDiagnostics(deviceLink, protocol, idlePolicy);
    deviceLink.declareIn(diagnostics(), parameterTable());
    lmsDiagnostics.declareIn(diagnostics());
    settings.declareIn(parameterTable());
    idlePolicy.declareIn(parameterTable());
    parameterTable().declareReadOnly("status", "how the laser is", () -> health.inWords());
    parameterTable()
        .declareReadOnly(
            "flash_writes",
            "how often its flash memory was written since the start",
            () -> Integer.toString(protocol.flashWrites()));
  }

  @Override
  protected ReopeningLink link() {
    return deviceLink;
  }

  @Override
  protected Duration longestAge() {
    return longestAge;
  }

  @Override
  protected void onClientCount(int number) {
    idlePolicy.setClients(number);
  }

  /** {@inheritDoc} While it is idle, the rate that it has with clients. */
  @Override
  public double updateRate() {
    if (settings.isPolled()) {
      return 1 / settings.period();
    }
    return settings.variant().rate(persona.baud());
  }

  /**
   * {@inheritDoc} It starts an idle laser.
   *
   * @throws NotReadyException if none has been received yet, or the last one has expired
   */
  @Override
  public RangeScan scan() {
    boolean wasIdle = idlePolicy.mayIdle();
    idlePolicy.used();
    if (wasIdle && latest().isTooOld()) {
      throw new NotReadyException(
          path(),
          readiness(),
          "it is idle, since no client used it for "
              + idlePolicy.idleSeconds()
              + " s; it starts now, ask again in a second");
    }
    return latest().get();
  }

  @Override
  protected List<? extends Attributes> deviceAttributes() {
    return persona.all();
  }

  /** Receives the protocol's events; on the reader thread. */
  private final class Reader implements LmsListener {

    private boolean malformedReported;

    @Override
    public void messageReceived(String name) {
      deviceLink.eventCounter().increment(name);
    }

    @Override
    public void scanReceived(LmsScan scan, MeasuringMode mode, LmsVariant variant, int baud) {
      double seconds = variant.duration() + 10.0 * variant.telegramBytes() / baud;
      Instant measured = clock().instant().minusNanos(Math.round(1e9 * seconds));
      double period = settings.isPolled() ? settings.period() : 1 / variant.rate(baud);
      RangeScan reading =
          new RangeScan(
              measured,
              path(),
              variant.firstAngle(),
              variant.step(),
              variant.duration(),
              0,
              mode.maxRange(scan.unit()),
              scan.ranges(mode));
      longestAge = Duration.ofMillis(Math.round(500 + 3000 * period));
      persona.updateRangeAttributes(mode, scan.unit(), variant);
      latest().set(reading);
      deviceLink.eventCounter().increment(LmsDiagnostics.SCAN);
      publish(reading);
    }

    @Override
    public void telegramReceived(LmsMessage.Telegram telegram) {
      deviceLink.reportAlive();
      if (!telegram.status().equals(health)) {
        health = telegram.status();
        log.info("{}: status {}", path(), health.inWords());
      }
      lmsDiagnostics.telegramReceived(telegram);
      persona.update(telegram);
    }

    @Override
    public void malformedReceived(String name, String reason) {
      if (malformedReported) {
        log.debug("malformed {}: {}", name, reason);
      } else {
        malformedReported = true;
        log.warn(
            "malformed {}: {}; more of them until scans come are logged at DEBUG", name, reason);
      }
    }

    @Override
    public void warn(String sentence) {
      log.warn("{}: {}", path(), sentence);
    }

    @Override
    public void awaiting(String what) {
      latest().setMissing(what);
    }

    @Override
    public void scansLost(String reason) {
      malformedReported = false;
      latest().markLost(reason);
    }

    @Override
    public boolean isIdleRequested() {
      return readiness().serves() && idlePolicy.mayIdle();
    }
  }
}
