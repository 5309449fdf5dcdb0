package org.dfra.drivers.laser.lms;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.core.module.LatestReading;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.jspecify.annotations.Nullable;

/**
 * SICK LMS 200 scanning laser, and those of its relatives that speak its telegrams.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}, {@code reopen_first}, {@code reopen_longest}: see {@link LinkSettings}
 *   <li>{@code baud}: bits per second to work at: 9600, 19200, 38400, 500000, or {@code keep} to
 *       use the line as it is. Default 38400 on {@code serial:} and {@code sim:}, else {@code
 *       keep}: a serial server's speed is its own, and only one that follows the laser's may be
 *       given another
 *   <li>{@code field_of_view}: degrees, 180 (default) or 100; {@code resolution}: degrees, 0.5
 *       (default), 1, or 0.25 with field_of_view 100; both can be set while it runs
 *   <li>{@code units}: {@code mm} (default), {@code cm} or {@code keep}; {@code measuring_mode}: 0
 *       to 6, 15 or {@code keep} (default), see {@link MeasuringMode}. They stand in the laser's
 *       flash memory, which is written only where it differs
 *   <li>{@code mode}: {@code continuous} (default) or {@code polled}, every {@code period} seconds,
 *       0.02 to 60, default 1; both can be set while it runs
 *   <li>{@code idle_after}: seconds without clients before it stops sending, 0 to 3600, 0 is never;
 *       default 10; can be set while it runs
 *   <li>{@code mount_frame}, {@code mount_x} and so on: where it is, see {@link SensorImpl}
 *   <li>to be read only: {@code status}, {@code flash_writes}, and those of {@link DeviceLine}
 * </ul>
 *
 * <p>INITIALIZING until the first scan, and again when the link is lost, when the laser does not
 * answer, or when no scan came for three periods and 2 s. A laser that rests is READY but has no
 * scan; the first client wakes it, and so does {@link #scan}. What it can be examined for is in
 * {@link LmsExamination}.
 *
 * <p>A scan's time is when its last byte came, less the time its telegram takes on the line and the
 * time the mirror takes for it; how long the laser thinks in between is not known, and not counted.
 *
 * <p>Threads: one reader ({@code name reader}), owned by a {@link DeviceLine} from {@code start} to
 * {@code close}, does all the work. Askers see immutable snapshots and never wait for the laser.
 */
public final class LmsImpl extends SensorImpl implements RangeSensor {

  private final LatestReading<RangeScan> latest;
  private final LmsOrders orders;
  private final LmsRest rest;
  private final LmsProtocol protocol;
  private final DeviceLine line;
  private final LmsExamination examination;
  private final LmsPersona persona;

  // written by the reader, read by anyone
  private volatile Duration longestAge = Duration.ZERO; // of a scan, at the rate of the last
  private volatile StatusByte health = StatusByte.OK;

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public LmsImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /**
   * For tests: by another time, and over links made in another way.
   *
   * @param source opens the link; null to go by the parameter {@code link}
   */
  LmsImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "SICK LMS 200 scanning laser",
        "DFRA",
        "1.0",
        List.of("RangeScan"),
        LmsExamination.PRECONDITIONS);
    this.latest = new LatestReading<>("scan", this, this::become, ticker::nanos, () -> longestAge);
    this.orders = LmsOrders.in(settings());
    this.rest = new LmsRest(ticker, LmsOrders.idleAfterIn(settings()));
    this.persona = new LmsPersona(orders);
    Reader reader = new Reader();
    this.protocol = new LmsProtocol(orders, ticker, reader);
    this.line = new DeviceLine(context, protocol, ticker, source, log);
    this.examination = new LmsExamination(line, protocol, rest);
    line.declareIn(examinations(), declared());
    examination.declareIn(examinations());
    orders.declareIn(declared());
    rest.declareIn(declared());
    declared().show("status", "how the laser is", () -> health.inWords());
    declared()
        .show(
            "flash_writes",
            "how often its flash memory was written since the start",
            () -> Integer.toString(protocol.writes()));
  }

  @Override
  protected void onStart() {
    latest.awaits("its link is being opened");
    line.start();
  }

  @Override
  protected void onClose() {
    line.close();
    latest.forget("it has ended");
  }

  @Override
  protected void onClients(int number) {
    rest.setClients(number);
  }

  /** {@inheritDoc} While it rests, of the time when it works again. */
  @Override
  public double updateRate() {
    if (orders.isPolled()) {
      return 1 / orders.period();
    }
    return orders.variant().rate(persona.baud());
  }

  /**
   * {@inheritDoc} It wakes a laser that rests.
   *
   * @throws NotReadyException if there has been none yet, or none for so long that the last one
   *     does not count any more
   */
  @Override
  public RangeScan scan() {
    boolean rested = rest.isDue();
    rest.used();
    if (rested && latest.isTooOld()) {
      throw new NotReadyException(
          path(),
          readiness(),
          "it rests, since nobody used it for "
              + rest.idleSeconds()
              + " s; it wakes now, ask again in a second");
    }
    return latest.get();
  }

  @Override
  protected List<? extends Attributes> traits() {
    return persona.all();
  }

  /** Takes what the protocol tells; on the reader thread. */
  private final class Reader implements LmsListener {

    private boolean toldMalformed;

    @Override
    public void heard(String name) {
      line.heard().count(name);
    }

    @Override
    public void scanned(LmsScan scan, MeasuringMode mode, LmsVariant variant, int baud) {
      double seconds = variant.duration() + 10.0 * variant.telegramBytes() / baud;
      Instant measured = clock().instant().minusNanos(Math.round(1e9 * seconds));
      double period = orders.isPolled() ? orders.period() : 1 / variant.rate(baud);
      RangeScan reading =
          new RangeScan(
              measured,
              path(),
              variant.firstAngle(),
              variant.step(),
              variant.duration(),
              0,
              mode.longest(scan.unit()),
              scan.ranges(mode));
      longestAge = Duration.ofMillis(Math.round(500 + 3000 * period));
      persona.sees(mode, scan.unit(), variant);
      latest.set(reading);
      line.heard().count(LmsExamination.SCAN);
      tell(reading);
    }

    @Override
    public void told(LmsMessage.Telegram telegram) {
      line.alive();
      if (!telegram.status().equals(health)) {
        health = telegram.status();
        log.info("{}: status {}", path(), health.inWords());
      }
      examination.told(telegram);
      persona.told(telegram);
    }

    @Override
    public void malformed(String name, String reason) {
      if (toldMalformed) {
        log.debug("malformed {}: {}", name, reason);
      } else {
        toldMalformed = true;
        log.warn("malformed {}: {}; more of them until scans come are told at DEBUG", name, reason);
      }
    }

    @Override
    public void warned(String sentence) {
      log.warn("{}: {}", path(), sentence);
    }

    @Override
    public void awaits(String what) {
      latest.awaits(what);
    }

    @Override
    public void withoutScans(String reason) {
      toldMalformed = false;
      latest.lose(reason);
    }

    @Override
    public boolean rests() {
      return readiness().serves() && rest.isDue();
    }
  }
}
