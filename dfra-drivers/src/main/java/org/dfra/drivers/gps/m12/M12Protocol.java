package org.dfra.drivers.gps.m12;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.dfra.drivers.gps.GpsReceiverProtocol;
import org.dfra.drivers.gps.GpsReceiverProtocol.GpsSolution;
import org.dfra.drivers.gps.m12.M12Message.HeldPosition;
import org.dfra.drivers.gps.m12.M12Message.M12UtcOffset;
import org.dfra.drivers.gps.m12.M12Message.MalformedMessage;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.PositionHoldMode;
import org.dfra.drivers.gps.m12.M12Message.ReceiverClock;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.drivers.gps.m12.M12Message.TimeScale;
import org.dfra.drivers.gps.m12.M12Message.VisibleSatellites;
import org.dfra.drivers.gps.m12.M12PositionMessage.ShortPosition;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.persona.GpsReceiverAttributes;
import org.jspecify.annotations.Nullable;

/**
 * The exchange between the driver and the receiver, from one opening of the link to the next.
 *
 * <p>It queries the receiver's identification ({@code @@Cj}), sets it to a safe state (time as UTC,
 * {@code @@Aw}; a position that is solved for, not held, {@code @@Gd}; time RAIM on, {@code @@Ge}),
 * resends what is not acknowledged, and requests {@code @@Ha} and {@code @@Hn} at the set rate, and
 * {@code @@Bb} and {@code @@Bo} on change. A receiver that has sent no position after {@value
 * #PATIENCE_SECONDS} s is asked for {@code @@Ea} and {@code @@En} too, because it may have only
 * eight channels. Once a twelve-channel position has been received, {@code @@Ea} is ignored, and
 * the receiver is commanded to stop it if it was requested. {@code @@At} sets whether a receiver of
 * eight channels holds its position; it does where the last {@code @@At} was 1.
 *
 * <p>Confined to the reader thread, except the last received reports, which any thread may read.
 */
final class M12Protocol implements GpsReceiverProtocol {

  private static final int PATIENCE_SECONDS = 2;

  private static final String UTC_UNKNOWN =
      "has not yet learned from the satellites how far GPS time is ahead of UTC; after a cold start"
          + " that takes up to 12.5 minutes";
  private static final String SCALE_UNKNOWN =
      "has not yet confirmed (@@Aw) that it reports UTC and not GPS time";
  private static final String NO_SATELLITE =
      "tracks no satellite, so its time is that of its own clock";

  private final M12ReportingPeriod rate;
  private final M12ReceiverSettings settings;
  private final InstantSource clock;
  private final Ticker ticker;
  private final Listener listener;
  private final M12Parser parser = new M12Parser(this::messageReceived);
  private final AckTracker acks;
  private final M12SatelliteTracker satelliteTracker = new M12SatelliteTracker();

  private int sentPeriod;
  private PositionControl.@Nullable Mode sentPositioning;
  private boolean isConfigurationDue;
  private long openedNanos;
  private boolean has12Channels;
  private boolean asked8Channels;
  private boolean sentUtc;
  private PositionHoldMode.@Nullable Mode positionHold; // of an eight-channel receiver
  private boolean asksPositionHold;

  // written by the reader, read by any thread
  private volatile @Nullable ReceiverStatus status;
  private volatile @Nullable TimeRaim timeRaim;
  private volatile @Nullable HeldPosition held;
  private volatile @Nullable ReceiverClock receiverClock;
  private volatile @Nullable M12UtcOffset utcOffset;
  private volatile @Nullable ReceiverIdentification identification;

  /**
   * @param clock gives the time of reports while UTC is unconfirmed
   */
  M12Protocol(
      M12ReportingPeriod rate,
      M12ReceiverSettings orders,
      InstantSource clock,
      Ticker ticker,
      Listener listener) {
    this.rate = rate;
    this.settings = orders;
    this.clock = clock;
    this.ticker = ticker;
    this.listener = listener;
    this.acks = new AckTracker(ticker);
  }

  /** The last receiver status; empty before the first of a link. */
  Optional<ReceiverStatus> status() {
    return Optional.ofNullable(status);
  }

  /** The last time RAIM message; empty before the first of a link. */
  Optional<TimeRaim> timeRaim() {
    return Optional.ofNullable(timeRaim);
  }

  /** The position for position hold; empty before the receiver has reported it. */
  Optional<HeldPosition> held() {
    return Optional.ofNullable(held);
  }

  /** The receiver's clock as last set or reported. */
  Optional<ReceiverClock> clock() {
    return Optional.ofNullable(receiverClock);
  }

  /** GPS time minus UTC; empty before the receiver has reported it. */
  Optional<M12UtcOffset> utcOffset() {
    return Optional.ofNullable(utcOffset);
  }

  /** The receiver's identification; empty until it is received. */
  Optional<ReceiverIdentification> identification() {
    return Optional.ofNullable(identification);
  }

  @Override
  public void opened(SerialLink link) throws IOException {
    has12Channels = false;
    status = null;
    timeRaim = null;
    held = null;
    receiverClock = null;
    utcOffset = null;
    sentUtc = false;
    positionHold = null;
    asksPositionHold = false;
    satelliteTracker.forget();
    begin(link);
  }

  private void begin(SerialLink link) throws IOException {
    isConfigurationDue = false;
    asked8Channels = false;
    openedNanos = ticker.nanos();
    acks.forget();
    link.write(M12Commands.identification());
    acks.send(link, "Aw", M12Commands.utcTime());
    sendPositioning(link);
    sentPeriod = rate.now();
    link.write(position(sentPeriod));
    acks.send(link, "Ge", M12Commands.timeRaimOn());
    link.write(M12Commands.timeRaimOf12Channels(sentPeriod));
    link.write(M12Commands.visibleSatellites(true));
    link.write(M12Commands.utcOffset());
    link.write(M12Commands.askHoldPosition());
  }

  private byte[] position(int seconds) {
    return settings.shortPositions()
        ? M12Commands.shortPosition(seconds)
        : M12Commands.positionOf12Channels(seconds);
  }

  @Override
  public M12Parser parser() {
    return parser;
  }

  @Override
  public void periodic(SerialLink link) throws IOException {
    if (isConfigurationDue) {
      begin(link);
    }
    sendPeriod(link);
    if (settings.positioning() != sentPositioning) {
      sendPositioning(link);
    }
    String unacknowledged = acks.resendDue(link);
    if (unacknowledged != null
        && has12Channels) { // an eight-channel receiver does not know them all
      listener.warn("the receiver has not acknowledged @@" + unacknowledged + ", which it should");
    }
    if (has12Channels && asked8Channels) {
      asked8Channels = false;
      link.write(M12Commands.positionOf8Channels(0)); // one more, then none
      link.write(M12Commands.timeRaimOf8Channels(0));
    } else if (!has12Channels
        && !asked8Channels
        && ticker.nanos() - openedNanos > Duration.ofSeconds(PATIENCE_SECONDS).toNanos()) {
      asked8Channels = true;
      sendPositionHold(link);
      link.write(M12Commands.positionOf8Channels(sentPeriod));
      link.write(M12Commands.timeRaimOf8Channels(sentPeriod));
    }
    if (asksPositionHold) {
      asksPositionHold = false;
      link.write(M12Commands.askPositionHold());
    }
  }

  private void sendPositioning(SerialLink link) throws IOException {
    PositionControl.Mode target = settings.positioning();
    sentPositioning = target;
    acks.send(link, "Gd", M12Commands.positionControl(target));
    if (asked8Channels) {
      sendPositionHold(link);
    }
  }

  /**
   * Eight-channel receivers have no {@code @@Gd}, and no altitude hold that this driver supports.
   */
  private void sendPositionHold(SerialLink link) throws IOException {
    PositionControl.Mode target = settings.positioning();
    acks.send(
        link,
        "At",
        M12Commands.positionHold(
            switch (target) {
              case HOLD -> PositionHoldMode.Mode.ON;
              case SURVEY -> PositionHoldMode.Mode.SURVEY;
              case POSITION_3D, ALTITUDE_HOLD -> PositionHoldMode.Mode.OFF;
            }));
    if (target == PositionControl.Mode.ALTITUDE_HOLD) {
      listener.warn(
          "a receiver of eight channels cannot be set to altitude_hold by this driver; it solves"
              + " for a 3-D position");
    }
  }

  private void sendPeriod(SerialLink link) throws IOException {
    int target = rate.now();
    if (target != sentPeriod) {
      sentPeriod = target;
      link.write(position(target));
      link.write(M12Commands.timeRaimOf12Channels(target));
      if (asked8Channels) {
        link.write(M12Commands.positionOf8Channels(target));
        link.write(M12Commands.timeRaimOf8Channels(target));
      }
    }
  }

  private void messageReceived(M12Message message) {
    if (message instanceof M12PositionMessage position) {
      take(position);
    } else if (message instanceof MalformedMessage malformed) {
      listener.malformedReceived("@@" + malformed.id(), malformed.reason());
      return;
    } else {
      store(message);
    }
    acks.acknowledge(message.id());
    listener.messageReceived(message.id());
  }

  private void take(M12PositionMessage position) {
    if (position instanceof Position8Channels eight) {
      if (!has12Channels) {
        solved(eight);
      }
    } else {
      has12Channels = true;
      if (settings.shortPositions() == position instanceof ShortPosition) {
        solved(position);
      }
    }
  }

  private void solved(M12PositionMessage message) {
    if (message instanceof Position12Channels twelve) {
      status = twelve.status();
    } else if (message instanceof ShortPosition brief) {
      status = brief.status();
    }
    if (sentPeriod == rate.now()) {
      rate.arrivedAtThisRate();
    }
    boolean mayHold = message instanceof Position8Channels eight && eight.mayHold();
    boolean holds = mayHold && positionHold == PositionHoldMode.Mode.ON;
    // A survey ends without a message: the receiver then holds, and reports it when queried.
    asksPositionHold |= mayHold && positionHold == PositionHoldMode.Mode.SURVEY;
    GpsFix.Mode mode = holds ? GpsFix.Mode.POSITION_HOLD : message.mode();
    listener.satellitesReceived(satelliteTracker.with(message, mode));
    String unconfirmedReason = utcUnconfirmedReason(message, holds);
    Instant utc = unconfirmedReason == null ? message.utc() : clock.instant();
    listener.solutionReceived(
        new GpsSolution(
            message.toFix(mode, utc),
            unconfirmedReason,
            holds
                ? ReceiverStatus.State.POSITION_HOLD.inWords(message.tracked(), message.visible())
                : message.stateInWords()));
    reportIdentity(); // the number of channels may have become known
  }

  private @Nullable String utcUnconfirmedReason(M12PositionMessage message, boolean holds) {
    if (holds && message.tracked() == 0) {
      return NO_SATELLITE;
    }
    if (message.knowsUtc()) {
      return null;
    }
    if (message instanceof Position12Channels || utcOffset == null) {
      return UTC_UNKNOWN;
    }
    return sentUtc ? null : SCALE_UNKNOWN;
  }

  private void store(M12Message message) {
    if (message instanceof VisibleSatellites visible) {
      listener.satellitesReceived(satelliteTracker.with(visible));
    } else if (message instanceof TimeRaim raim) {
      timeRaim = raim;
    } else if (message instanceof HeldPosition position) {
      held = position;
    } else if (message instanceof ReceiverClock reported) {
      receiverClock = reported;
    } else if (message instanceof M12UtcOffset offset) {
      utcOffset = offset.isKnown() ? offset : null;
    } else if (message instanceof PositionHoldMode hold) {
      positionHold = hold.mode();
    } else if (message instanceof TimeScale scale) {
      sentUtc = scale.isUtc();
    } else if (message instanceof ReceiverIdentification reported) {
      identification = reported;
      reportIdentity();
    } else if (message.id().equals("Cf")) {
      isConfigurationDue = true; // it sends nothing any more
    }
  }

  private void reportIdentity() {
    ReceiverIdentification reported = identification;
    Integer channels = has12Channels ? Integer.valueOf(12) : asked8Channels ? 8 : null;
    List<String> modes = List.of("2D", "3D");
    listener.identityReceived(
        reported == null
            ? new GpsReceiverAttributes(null, null, null, null, channels, modes)
            : new GpsReceiverAttributes(
                known(reported.model()),
                known(reported.serialNumber()),
                known(reported.softwarePartNumber()),
                known(reported.softwareVersion()),
                channels,
                modes));
  }

  private static @Nullable String known(String text) {
    return text.isEmpty() ? null : text;
  }
}
