package org.dfra.drivers.gps.m12;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ParameterTable.Range;
import org.dfra.core.module.SensorImpl;
import org.dfra.drivers.link.BackOff;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.Described;
import org.jspecify.annotations.Nullable;

/**
 * Motorola Oncore M12+ GPS receiver, and its eight-channel forerunners.
 *
 * <p>Parameters:
 *
 * <ul>
 *   <li>{@code link}: where the receiver is, a {@link LinkAddress}, e.g. {@code
 *       serial:/dev/ttyS0?baud=9600}; required
 *   <li>{@code rate}: seconds from one position to the next, a whole number from 1 to 255; default
 *       1; can be set while it runs
 *   <li>{@code idle_rate}: the same while the last client is gone, not less than {@code rate};
 *       default 10; can be set while it runs
 *   <li>{@code reopen_first}, {@code reopen_longest}: seconds to wait before a lost link is opened
 *       again, at first and at most; default 0.5 and 8
 *   <li>{@code mount_frame}, {@code mount_x} and so on: where the antenna is, see {@link
 *       SensorImpl}
 * </ul>
 *
 * <p>A receiver that has had no client yet works at {@code rate}, so that it is warm when the first
 * one comes. What it can be examined for is in {@link M12Examination}.
 *
 * <p>INITIALIZING until the first position, and again when the link is lost, when no position frame
 * came for three periods and 2 s (then the link is opened anew), or when none of them had a
 * position for that long (then it stays open). A position is served no longer than that either.
 *
 * <p>Positions are the receiver's filtered ones, with the height above the ellipsoid; speed is the
 * one over ground.
 *
 * <p>Threads: one reader ({@code name reader}), owned by a {@link LinkKeeper} from {@code start} to
 * {@code close}, does all the work. Askers see immutable snapshots and never wait for the device.
 */
public final class M12PlusImpl extends SensorImpl implements GPSSensor, Described {

  /**
   * What the receiver last told; immutable.
   *
   * @param fix the last solution, with a position or without
   * @param location the last position
   * @param time the time that came with it
   * @param knowsUtc whether that time is UTC for sure
   * @param positionNanos when that position came, by the ticker
   */
  private record Snapshot(
      GpsFix fix,
      LocationReading location,
      TimeReading time,
      boolean knowsUtc,
      long positionNanos) {}

  /** Seconds; the receiver takes no more. */
  private static final int LONGEST_PERIOD = 255;

  private final M12Rate rate;
  private final M12Heard heard;
  private final Ticker ticker;
  private final LinkKeeper keeper;
  private final M12Attributes attributes;

  // written by the reader, read by anyone
  private volatile @Nullable Snapshot snapshot;
  private volatile @Nullable ReceiverIdentification receiver;
  private volatile @Nullable ReceiverStatus status;
  private volatile @Nullable Integer channels;
  private volatile M12Counts counts = M12Counts.ZERO;
  private volatile String awaits = "it has not been started";

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or wrong
   */
  public M12PlusImpl(ModuleContext context) {
    this(context, Ticker.of(context.clock()), null);
  }

  /**
   * For tests: by another time, and over links made in another way.
   *
   * @param source opens the link; null to go by the parameter {@code link}
   */
  M12PlusImpl(ModuleContext context, Ticker ticker, LinkKeeper.@Nullable Source source) {
    super(
        context,
        "Motorola Oncore M12+ GPS receiver",
        "DFRA",
        "1.0",
        List.of("GpsFix"),
        M12Examination.PRECONDITIONS);
    LinkAddress address = addressIn(settings());
    this.ticker = ticker;
    this.rate =
        new M12Rate(secondsIn(settings(), "rate", 1), secondsIn(settings(), "idle_rate", 10));
    this.heard = new M12Heard(ticker);
    this.attributes = new M12Attributes();
    M12Dialogue dialogue = new M12Dialogue(rate, ticker, log, new Reader());
    this.keeper =
        new LinkKeeper(
            context.name(),
            source == null ? () -> address.open(ticker) : source,
            dialogue,
            backOffIn(settings()),
            ticker,
            log);
    declareParameters();
    new M12Examination(
            keeper, dialogue, heard, rate, () -> Optional.ofNullable(status), this::receiver)
        .declareIn(examinations());
  }

  private void declareParameters() {
    Range seconds = Range.whole(1, LONGEST_PERIOD, "s");
    declared()
        .number(
            "rate",
            "from one position to the next",
            seconds,
            rate::working,
            value -> rate.setWorking((int) value));
    declared()
        .number(
            "idle_rate",
            "from one position to the next when the last client has gone",
            seconds,
            rate::idle,
            value -> rate.setIdle((int) value));
  }

  @Override
  protected void onClients(int number) {
    rate.rest(number == 0);
  }

  @Override
  protected void onStart() {
    awaits = "its link is being opened";
    keeper.start();
  }

  @Override
  protected void onClose() {
    keeper.close();
    awaits = "it has ended";
    snapshot = null;
  }

  /** {@inheritDoc} As set by {@code rate}, or {@code idle_rate} when the last client has gone. */
  @Override
  public double updateRate() {
    return 1.0 / rate.now();
  }

  /**
   * {@inheritDoc} It may have the mode NONE while the receiver has just lost its satellites.
   *
   * @throws NotReadyException if there has been none yet, or none for so long that the last one
   *     does not count any more
   */
  @Override
  public GpsFix fix() {
    return current().fix();
  }

  /**
   * {@inheritDoc} The frame is the receiver's antenna, {@code robot/name}.
   *
   * @throws NotReadyException as {@link #fix}
   */
  @Override
  public LocationReading location() {
    return current().location();
  }

  /**
   * {@inheritDoc} During a leap second it stands still.
   *
   * @throws NotReadyException as {@link #fix}, and while the receiver does not know yet how far GPS
   *     time and UTC are apart
   */
  @Override
  public TimeReading time() {
    Snapshot current = current();
    if (!current.knowsUtc()) {
      throw new NotReadyException(
          identification().path(),
          readiness(),
          "the receiver has positions, but has not yet learned from the satellites how far GPS time"
              + " is ahead of UTC; after a cold start that takes up to 12.5 minutes");
    }
    return current.time();
  }

  /** What the receiver says it is; empty until it has said so. */
  public Optional<ReceiverIdentification> receiver() {
    return Optional.ofNullable(receiver);
  }

  /** {@inheritDoc} The location is one that the receiver was at not long ago. */
  @Override
  public List<Attributes> attributes() {
    @Nullable Snapshot current = readiness().serves() ? snapshot : null;
    return attributes.all(
        receiver,
        channels,
        current == null ? null : current.location(),
        frame(),
        parentFrame(),
        localTransform());
  }

  /** What has come over the link since the module was started, all openings together. */
  public M12Counts counts() {
    return counts;
  }

  private Snapshot current() {
    Snapshot current = snapshot;
    Readiness readiness = readiness();
    if (current == null || !readiness.serves()) {
      throw new NotReadyException(identification().path(), readiness, awaits);
    }
    Duration longestAge = rate.longestAge();
    long age = ticker.nanos() - current.positionNanos();
    if (age > longestAge.toNanos()) {
      throw new NotReadyException(
          identification().path(),
          readiness,
          String.format(
              Locale.ROOT,
              "its last position is %.1f s old, and none older than %d s is served",
              age / 1e9,
              longestAge.toSeconds()));
    }
    return current;
  }

  /** Takes what the dialogue tells; on the reader thread. */
  private final class Reader implements M12Dialogue.Listener {

    @Override
    public void solved(M12PositionMessage message) {
      heard.count(M12Heard.Sort.SOLUTION);
      if (message instanceof Position12Channels position) {
        status = position.status();
      }
      Instant now = clock().instant();
      channels = message.channels().size();
      GpsFix fix = message.toFix();
      Snapshot last = snapshot;
      if (fix.position() != null) {
        snapshot =
            new Snapshot(
                fix,
                new LocationReading(fix.position(), identification().path(), fix.utc()),
                new TimeReading(fix.utc(), now),
                message.knowsUtc(),
                ticker.nanos());
        if (readiness() == Readiness.INITIALIZING) {
          become(Readiness.READY);
        }
        tell(fix);
      } else if (last != null) {
        snapshot =
            new Snapshot(fix, last.location(), last.time(), last.knowsUtc(), last.positionNanos());
        tell(fix);
      } else {
        awaits = "the receiver has no position yet, it is " + message.stateInWords();
      }
    }

    @Override
    public void defaulted() {
      heard.count(M12Heard.Sort.DEFAULTS);
    }

    @Override
    public void opened() {
      status = null;
      heard.count(M12Heard.Sort.OPENING);
    }

    @Override
    public void identified(ReceiverIdentification identification) {
      if (!identification.equals(receiver)) {
        receiver = identification;
        log.info("{}: {}", identification().path(), identification);
      }
      heard.count(M12Heard.Sort.IDENTIFICATION);
    }

    @Override
    public void counted(M12Counts now) {
      counts = now;
    }

    @Override
    public void withoutPosition(String reason) {
      awaits = reason;
      if (readiness().serves()) {
        become(Readiness.INITIALIZING, reason);
      }
      snapshot = null;
    }
  }

  private static LinkAddress addressIn(Parameters parameters) {
    try {
      return LinkAddress.parse(parameters.text("link"));
    } catch (IllegalArgumentException e) {
      throw parameters.fault("link", "a usable link: " + e.getMessage(), e);
    }
  }

  private static int secondsIn(Parameters parameters, String name, int fallback) {
    double seconds = parameters.number(name, fallback, 1, LONGEST_PERIOD);
    if (seconds != Math.rint(seconds)) {
      throw parameters.fault(name, "a whole number of seconds", null);
    }
    return (int) seconds;
  }

  private static BackOff backOffIn(Parameters parameters) {
    Duration shortest = Duration.ofMillis(10);
    Duration hour = Duration.ofHours(1);
    Duration first = parameters.seconds("reopen_first", Duration.ofMillis(500), shortest, hour);
    Duration longest = parameters.seconds("reopen_longest", Duration.ofSeconds(8), shortest, hour);
    if (longest.compareTo(first) < 0) {
      String set =
          parameters.find("reopen_longest").isPresent() ? "reopen_longest" : "reopen_first";
      throw parameters.fault(
          set,
          "in order: reopen_first is "
              + first.toMillis() / 1e3
              + " s and reopen_longest "
              + longest.toMillis() / 1e3
              + " s, but it must be at least as long",
          null);
    }
    return new BackOff(first, longest);
  }
}
