package org.dfra.drivers.gps;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.device.LinkedSensorImpl;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.link.EventCounter;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.LinkSettings;
import org.dfra.drivers.link.ReopeningLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.module.NotReadyException;
import org.dfra.persona.Attributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Common base of the drivers of receivers that stream fixes over a link. The driver of a new
 * receiver extends this class and supplies its {@link GpsReceiverProtocol}.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}: where the receiver is, a {@link LinkAddress}, e.g. {@code
 *       serial:/dev/ttyS0?baud=9600}; required
 *   <li>{@code reopen_initial_delay}, {@code reopen_max_delay}: initial and maximum wait before a
 *       lost link is reopened, seconds; default 0.5 and 8
 *   <li>{@code mount_frame}, {@code mount_x} and so on: the antenna's pose, see {@link
 *       org.dfra.core.module.SensorImpl}
 *   <li>read-only: {@code satellites}, {@code accuracy}, {@code frames}, {@code dropped_bytes},
 *       {@code malformed_frames}
 * </ul>
 *
 * <p>The module is INITIALIZING until the first position, and again when the link is lost, when no
 * solution has been received for three periods and 2 s (then the link is reopened), or when no
 * solution has had a position for that time (then the link stays open). A position is served for
 * the same time.
 *
 * <p>Threads: one reader ({@code name reader}), owned by a {@link LinkKeeper} from {@code start} to
 * {@code close}, does all the work. Callers read immutable snapshots and never wait for the device.
 *
 * @param <P> the receiver's protocol
 */
public abstract class GpsReceiverImpl<P extends GpsReceiverProtocol>
    extends LinkedSensorImpl<GpsReceiverImpl.Snapshot> implements GPSSensor {

  /**
   * The receiver's last reports; immutable.
   *
   * @param solution the last solution, with a position or without
   * @param location the last position
   * @param time the time of that position
   * @param utcUnconfirmedReason why UTC is unconfirmed; null when it is confirmed
   */
  record Snapshot(
      GpsSolution solution,
      LocationReading location,
      TimeReading time,
      @Nullable String utcUnconfirmedReason) {}

  private final GpsReceiverType kind;
  private final ReportingPeriod reportingPeriod;
  private final P protocol;
  private final GpsLinkHandler linkHandler;
  private final LinkKeeper keeper;
  private final EventCounter eventCounter;
  private final GpsReceiverDiagnostics receiverDiagnostics;
  private final GpsReceiverPersona attributes;
  private final WeekRollover rollover;

  // written by the reader, read by any thread
  private volatile @Nullable GpsReceiverAttributes receiver;
  private volatile List<SatelliteInView> satellites = List.of();
  private volatile StreamCounts counts = StreamCounts.ZERO;

  private boolean malformedReported; // confined to the reader

  /**
   * @param context the driver's context
   * @param kind the receiver's type
   * @param reportingPeriod how often positions are expected
   * @param protocol makes the protocol, which notifies this listener
   * @param ticker the clock for waits
   * @param source opens the link; null to use the parameter {@code link}
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  protected GpsReceiverImpl(
      ModuleContext context,
      GpsReceiverType kind,
      ReportingPeriod reportingPeriod,
      Function<GpsReceiverProtocol.Listener, P> protocol,
      Ticker ticker,
      LinkKeeper.@Nullable Source source) {
    super(
        context,
        kind.description(),
        List.of("GpsFix", "LocationReading", "TimeReading"),
        kind.preconditions(),
        "position",
        ticker);
    LinkAddress address = LinkSettings.address(settings());
    this.kind = kind;
    this.reportingPeriod = reportingPeriod;
    this.eventCounter = new EventCounter(ticker);
    this.attributes = new GpsReceiverPersona(kind.sensor());
    this.rollover = WeekRollover.of(context.clock(), address);
    Reader reader = new Reader();
    this.protocol = protocol.apply(reader);
    this.linkHandler = new GpsLinkHandler(this.protocol, reportingPeriod, ticker, reader);
    this.keeper =
        new LinkKeeper(
            context.name(),
            source == null ? () -> address.open(ticker) : source,
            linkHandler,
            LinkSettings.backOff(settings()),
            ticker,
            log);
    this.receiverDiagnostics =
        new GpsReceiverDiagnostics(
            keeper, linkHandler::send, eventCounter, reportingPeriod, this::satellites);
    receiverDiagnostics.declareIn(diagnostics());
    declareStatistics();
  }

  private void declareStatistics() {
    parameterTable()
        .declareReadOnly(
            "satellites",
            "the satellites that the receiver receives now",
            () -> GpsReceiverDiagnostics.inWords(satellites));
    parameterTable()
        .declareReadOnly(
            "accuracy", "the receiver's estimate of its error, one sigma", this::accuracy);
    DeviceLink.showCounts(parameterTable(), () -> counts);
  }

  private String accuracy() {
    Snapshot last = latest().peek();
    return last == null || Double.isNaN(last.solution().horizontalAccuracy())
        ? "not reported"
        : String.format(
            Locale.ROOT,
            "horizontal %.2f m, vertical %.2f m",
            last.solution().horizontalAccuracy(),
            last.solution().verticalAccuracy());
  }

  @Override
  protected final ReopeningLink link() {
    return keeper;
  }

  /** {@inheritDoc} The age of the position. */
  @Override
  protected final Duration longestAge() {
    return reportingPeriod.longestAge();
  }

  /** {@inheritDoc} The currently configured rate. */
  @Override
  public double updateRate() {
    return 1 / reportingPeriod.seconds();
  }

  /**
   * {@inheritDoc} It may have the mode NONE while the receiver has just lost its satellites.
   *
   * @throws NotReadyException if none has been received yet, or the last one has expired
   */
  @Override
  public final GpsFix fix() {
    return latest().get().solution().fix();
  }

  /**
   * {@inheritDoc} The frame is the receiver's antenna, {@code robot/name}.
   *
   * @throws NotReadyException as {@link #fix}
   */
  @Override
  public final LocationReading location() {
    return latest().get().location();
  }

  /**
   * {@inheritDoc} It does not advance during a leap second.
   *
   * @throws NotReadyException as {@link #fix}, and while UTC is unconfirmed
   */
  @Override
  public final TimeReading time() {
    Snapshot current = latest().get();
    String unconfirmedReason = current.utcUnconfirmedReason();
    if (unconfirmedReason != null) {
      throw new NotReadyException(
          path(), readiness(), "the receiver has positions, but " + unconfirmedReason);
    }
    return current.time();
  }

  /** {@inheritDoc} The location is recent but may lag behind the receiver. */
  @Override
  protected final List<? extends Attributes> deviceAttributes() {
    return attributes.all(receiver());
  }

  /** The receiver's identity, as far as it has been reported. */
  public final GpsReceiverAttributes receiver() {
    GpsReceiverAttributes identity = receiver;
    return identity == null ? kind.receiver() : identity;
  }

  /** The satellites in view, as last reported. */
  public final List<SatelliteInView> satellites() {
    return satellites;
  }

  /** What has been received over the link since the module was started, over all openings. */
  public final StreamCounts counts() {
    return counts;
  }

  /** The receiver's protocol; other threads may call only the methods that allow it. */
  protected final P protocol() {
    return protocol;
  }

  /**
   * Queues bytes for the receiver; from any thread. They are discarded when the link is reopened.
   */
  protected final void send(byte[] bytes) {
    linkHandler.send(bytes);
  }

  /** The common diagnostics, for the driver's own tests. */
  protected final GpsReceiverDiagnostics receiverDiagnostics() {
    return receiverDiagnostics;
  }

  /** Receives the events of the protocol and the link handler; on the reader thread. */
  private final class Reader implements GpsReceiverProtocol.Listener, GpsLinkHandler.Listener {

    @Override
    public void solutionReceived(GpsSolution reported) {
      Instant utc = reported.fix().utc();
      Instant corrected = reported.reportsDate() ? rollover.correct(utc) : utc;
      GpsSolution solution = corrected.equals(utc) ? reported : reported.withTime(corrected);
      linkHandler.solutionReceived(solution);
      eventCounter.increment(GpsReceiverDiagnostics.SOLUTION);
      Instant now = clock().instant();
      GpsFix fix = solution.fix();
      Snapshot last = latest().peek();
      if (fix.position() != null) {
        LocationReading location = new LocationReading(fix.position(), path(), fix.utc());
        attributes.located(location);
        latest()
            .set(
                new Snapshot(
                    solution,
                    location,
                    new TimeReading(fix.utc(), now),
                    solution.utcUnconfirmedReason()));
        publish(fix);
      } else if (last != null) {
        latest()
            .replaceValue(
                new Snapshot(solution, last.location(), last.time(), last.utcUnconfirmedReason()));
        publish(fix);
      } else {
        latest().setMissing("the receiver has no position yet, it is " + solution.state());
      }
    }

    @Override
    public void satellitesReceived(List<SatelliteInView> now) {
      satellites = List.copyOf(now);
    }

    @Override
    public void identityReceived(GpsReceiverAttributes identity) {
      if (!identity.equals(receiver)) {
        receiver = identity;
        log.info("{}: {}", path(), identity);
      }
    }

    @Override
    public void messageReceived(String name) {
      eventCounter.increment(name);
    }

    @Override
    public void malformedReceived(String what, String reason) {
      if (malformedReported) {
        log.debug("malformed {}: {}", what, reason);
      } else {
        malformedReported = true;
        log.warn(
            "malformed {}: {}; more of them until the link is opened again are logged at DEBUG",
            what,
            reason);
      }
    }

    @Override
    public void warn(String sentence) {
      log.warn("{}: {}", path(), sentence);
    }

    @Override
    public void opened() {
      malformedReported = false;
      satellites = List.of();
      receiverDiagnostics.opened();
    }

    @Override
    public void countsChanged(StreamCounts now) {
      counts = now;
    }

    @Override
    public void positionLost(String reason) {
      latest().markLost(reason);
    }
  }
}
