package org.dfra.sim.device.gps;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.Schedule;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.dfra.sim.device.gps.M12EmulatorSettings.M12EmulatorOptions;
import org.dfra.sim.device.gps.M12Frames.Moment.Solution;
import org.dfra.sim.device.gps.M12Frames.Moment.TimeScale;
import org.jspecify.annotations.Nullable;

/**
 * Emulates an M12+ at the byte level of its serial interface.
 *
 * <p>Commands: {@code @@Ha}, {@code @@Hb}, {@code @@Hn}, {@code @@Ea}, {@code @@En} with a rate
 * byte (0 once, n at once and every n seconds), {@code @@Bb} and {@code @@Bo} (at once; where their
 * byte is not 0 also {@code @@Bb} every half minute, and {@code @@Bo} when it changes),
 * {@code @@Cj} (identification), {@code @@Aw} (1 selects UTC, 0 GPS time, FF queries), {@code @@Gd}
 * (0 to 3, FF queries), {@code @@At} (0 to 2, FF queries), {@code @@Ge} (time RAIM), {@code @@Gb}
 * (date and time, executed only without a fix), {@code @@As} (the position to hold; out of range
 * queries), {@code @@Cf} (defaults: ends all unsolicited messages). Unknown and damaged commands
 * are ignored. The settings survive a change of client, as a receiver keeps its settings when its
 * computer is disconnected.
 */
public final class M12Device extends UartDevice {

  /**
   * If more bytes than this are queued, the baud rate is too low for the requested messages; a
   * message is skipped.
   */
  private static final int LONGEST_QUEUE = 1024;

  private static final Set<String> OF_12_CHANNELS = Set.of("Ha", "Hb", "Hn", "Gd");

  private final AntennaTrajectory path;
  private final Duration timeToFirstFix;
  private final M12EmulatorOptions options;
  private final M12CommandReader commands = new M12CommandReader(this::execute);

  /** Seconds between two reports of the satellites, whose positions change slowly. */
  private static final int SKY_PERIOD = 30;

  private final Map<String, Schedule> schedules = new LinkedHashMap<>();
  private boolean reportsUtc = true;
  private boolean knowsUtc;
  private boolean reportsOffset; // when it changes
  private int reportedOffset;
  private int positionControl;
  private boolean timeRaim;
  private @Nullable GeoPosition held;
  private Duration clockError = Duration.ZERO; // of its own clock, before it has a fix
  private @Nullable Instant powerOn;
  private Instant now = Instant.EPOCH;

  /**
   * @param path trajectory of its antenna
   * @param baud bits per second of its serial line
   * @param timeToFirstFix time from the first {@link #receive} or {@link #transmit} to the first
   *     fix
   */
  public M12Device(AntennaTrajectory path, int baud, Duration timeToFirstFix) {
    this(path, baud, timeToFirstFix, M12EmulatorOptions.USUAL);
  }

  /**
   * The same.
   *
   * @param options number of channels, and when it learns UTC
   */
  public M12Device(
      AntennaTrajectory path, int baud, Duration timeToFirstFix, M12EmulatorOptions options) {
    super(baud);
    this.path = path;
    this.options = options;
    this.timeToFirstFix = timeToFirstFix;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    commands.feed(bytes, offset, length);
  }

  @Override
  protected void advance(Instant time) {
    if (powerOn == null) {
      powerOn = time;
    }
    now = time;
    knowsUtc |= !time.isBefore(powerOn.plus(options.timeToUtc())); // and does not forget it
    if (reportsOffset && reportedOffset != utcOffset()) {
      sendUtcOffset();
    }
    schedules.forEach(
        (id, schedule) -> {
          Instant due = schedule.due(time);
          if (due != null) {
            send(id, due);
          }
        });
  }

  private void execute(String id, byte[] argument) {
    if (options.channels() < 12 && OF_12_CHANNELS.contains(id)) {
      return;
    }
    int first = argument.length == 0 ? 0 : argument[0] & 0xFF;
    switch (id) {
      case "Ha", "Hb", "Hn", "Ea", "En" -> {
        timeRaim |= id.equals("En") && argument[1] == 1;
        repeat(id, first);
        send(id, now);
      }
      case "Bb" -> {
        repeat(id, first == 0 ? 0 : SKY_PERIOD);
        send(id, now);
      }
      case "Bo" -> {
        reportsOffset = first != 0;
        sendUtcOffset();
      }
      case "Cj" -> channel().send(M12Frames.identification(), now);
      case "Aw" -> setTimeScale(first);
      case "Gd" -> setPositionControl(first);
      case "At" -> setPositionHold(first);
      case "Ge" -> {
        timeRaim = first == 0xFF ? timeRaim : first == 1;
        acknowledge("Ge", timeRaim ? 1 : 0);
      }
      case "Gb" -> setClock(argument);
      case "As" -> setHeld(argument);
      case "Cf" -> {
        schedules.clear();
        reportsOffset = false;
        reportsUtc = true;
        positionControl = 0;
        timeRaim = false;
        channel().send(M12Frames.frame("Cf", new byte[0]), now);
      }
      default -> {
        // the receiver ignores unknown commands
      }
    }
  }

  private void repeat(String id, int seconds) {
    schedules.computeIfAbsent(id, unused -> new Schedule()).set(seconds, now);
  }

  private void acknowledge(String id, int value) {
    channel().send(M12Frames.frame(id, new byte[] {(byte) value}), now);
  }

  private void sendUtcOffset() {
    reportedOffset = utcOffset();
    acknowledge("Bo", reportedOffset);
  }

  /** GPS time minus UTC, seconds; 0 while it has not learned it. */
  private int utcOffset() {
    return knowsUtc ? M12Frames.UTC_OFFSET : 0;
  }

  private void setTimeScale(int argument) {
    if (argument <= 1 || argument == 0xFF) {
      reportsUtc = argument == 0xFF ? reportsUtc : argument == 1;
      acknowledge("Aw", reportsUtc ? 1 : 0);
    }
  }

  private void setPositionControl(int argument) {
    if (argument <= 3 || argument == 0xFF) {
      positionControl = argument == 0xFF ? positionControl : argument;
      if (argument == 1 && held == null) {
        held = path.at(now).position();
      }
      acknowledge("Gd", positionControl);
    }
  }

  /** The position-hold mode in the eight-channel form: off, on, survey. */
  private void setPositionHold(int argument) {
    if (argument <= 2) {
      positionControl = argument == 2 ? 3 : argument;
      if (argument == 1 && held == null) {
        held = path.at(now).position();
      }
    }
    acknowledge("At", positionControl == 3 ? 2 : positionControl == 1 ? 1 : 0);
  }

  private void setClock(byte[] argument) {
    Instant set = M12Frames.clockIn(argument);
    if (set != null && !hasFix(now)) {
      clockError = Duration.between(now, set);
    }
    channel().send(M12Frames.clock(reportedTime(now)), now);
  }

  private void setHeld(byte[] argument) {
    GeoPosition set = M12Frames.heldIn(argument);
    if (set != null) {
      held = set;
    }
    channel().send(M12Frames.held(held == null ? path.at(now).position() : held), now);
  }

  private Instant reportedTime(Instant time) {
    return hasFix(time) ? time : time.plus(clockError);
  }

  private void send(String id, Instant time) {
    if (channel().waitingBytes() > LONGEST_QUEUE) {
      return;
    }
    M12Frames.Moment moment =
        new M12Frames.Moment(
            reportedTime(time),
            utcOffset(),
            reportsUtc ? TimeScale.UTC : TimeScale.GPS,
            solution(time),
            antenna(time));
    channel()
        .send(
            switch (id) {
              case "Ha" -> M12Frames.position12(moment);
              case "Hb" -> M12Frames.shortPosition(moment);
              case "Hn" -> M12Frames.timeRaim12(moment, timeRaim);
              case "Ea" -> M12Frames.position8(moment);
              case "En" -> M12Frames.timeRaim8(moment, timeRaim);
              default -> M12Frames.visible(moment);
            },
            time);
  }

  private Solution solution(Instant time) {
    if (!hasFix(time)) {
      return Solution.ACQUIRING;
    }
    return holds() ? Solution.POSITION_HOLD : Solution.FIX_3D;
  }

  private boolean holds() {
    return positionControl == 1 && held != null;
  }

  private AntennaState antenna(Instant time) {
    AntennaState there = path.at(time);
    return positionControl == 1 && held != null ? new AntennaState(held, 0, 0) : there;
  }

  private boolean hasFix(Instant time) {
    return powerOn != null
        && !time.isBefore(powerOn.plus(timeToFirstFix))
        && path.hasSatellites(time);
  }
}
