package org.dfra.sim.device.gps;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.jspecify.annotations.Nullable;

/**
 * Encodes the frames that a receiver sends. Source: Motorola Oncore M12+ user's guide.
 *
 * <p>Pure functions; numbers are big-endian.
 */
final class M12Frames {

  /** GPS time minus UTC, seconds, since 2017. */
  static final int UTC_OFFSET = 18;

  static final int LENGTH_12 = 154;
  static final int LENGTH_8 = 76;
  static final int LENGTH_IDENTIFICATION = 294;

  private static final int AROUND_PAYLOAD = 7;
  private static final int CHANNEL_USED_12 = 0x08A0; // as a real receiver marks it
  private static final int CHANNEL_USED_8 = 0xA2;
  private static final int NARROW_BAND = 0x0400;
  private static final int TOO_FEW_SATELLITES = 0x0008;
  private static final int FIX_3D = 7 << 13;
  private static final int POSITION_HOLD = 4 << 13;
  private static final int ACQUIRING = 3 << 13;

  private M12Frames() {}

  /** {@code @@}, the two letters, the payload, checksum, CR LF. */
  static byte[] frame(String id, byte[] payload) {
    ByteBuffer frame = ByteBuffer.allocate(payload.length + AROUND_PAYLOAD);
    frame.put((byte) '@').put((byte) '@').put(id.getBytes(StandardCharsets.US_ASCII)).put(payload);
    byte checksum = 0;
    for (int i = 2; i < frame.position(); i++) {
      checksum ^= frame.get(i);
    }
    return frame.put(checksum).put((byte) '\r').put((byte) '\n').array();
  }

  /** {@code @@Ha}: position, status and data of twelve channels. */
  static byte[] position12(Moment moment) {
    SatelliteConstellation sky = moment.sky();
    AntennaState antenna = moment.antenna();
    ByteBuffer out = ByteBuffer.allocate(LENGTH_12 - AROUND_PAYLOAD);
    putTime(out, moment);
    putPosition(out, antenna.position()); // filtered
    putPosition(out, antenna.position()); // unfiltered
    putSpeed(out, antenna.speed()); // 3-D: the height is constant
    putSpeed(out, antenna.speed());
    out.putShort((short) Math.round(antenna.course() * 10));
    out.putShort((short) moment.dilution());
    out.put((byte) sky.visible()).put((byte) sky.tracked(12));
    for (int i = 0; i < 12; i++) {
      putChannel12(out, sky.channels(), i);
    }
    out.putShort((short) moment.status());
    out.putShort((short) 0).putShort((short) -12).putInt(99_800); // reserved, bias, oscillator
    out.putShort((short) 56); // 28 °C
    int isKnown = moment.utcOffset() != 0 ? 0x40 : 0;
    out.put((byte) ((moment.isUtc() ? 0x80 : 0) | isKnown | moment.utcOffset()));
    out.put((byte) 0).put((byte) 0).put((byte) 0); // local time is UTC
    out.put("EMU001".getBytes(StandardCharsets.US_ASCII));
    return frame("Ha", out.array());
  }

  /** {@code @@Ea}: position, status and data of eight channels. */
  static byte[] position8(Moment moment) {
    SatelliteConstellation sky = moment.sky();
    AntennaState antenna = moment.antenna();
    ByteBuffer out = ByteBuffer.allocate(LENGTH_8 - AROUND_PAYLOAD);
    putTime(out, moment);
    putPosition(out, antenna.position());
    putSpeed(out, antenna.speed());
    out.putShort((short) Math.round(antenna.course() * 10));
    out.putShort((short) moment.dilution());
    out.put((byte) 0); // PDOP, antenna OK
    out.put((byte) sky.visible()).put((byte) sky.tracked(8));
    for (SatelliteConstellation.Channel channel : sky.channels().subList(0, 8)) {
      out.put((byte) channel.satellite()).put((byte) channel.mode());
      out.put((byte) channel.carrierToNoise());
      out.put((byte) (channel.mode() == SatelliteConstellation.AVAILABLE ? CHANNEL_USED_8 : 0));
    }
    out.put(
        (byte)
            (switch (moment.solution()) {
              case ACQUIRING -> 0x08 | 0x02;
              case POSITION_HOLD -> 0x08;
              case FIX_3D -> 0x20;
            }));
    return frame("Ea", out.array());
  }

  /** {@code @@Cj}: the receiver's identification, in lines of text. */
  static byte[] identification() {
    List<String> lines =
        List.of(
            "EMULATED RECEIVER, NO COPYRIGHT",
            "SFTW P/N # 61-G10268A",
            "SOFTWARE VER # 2",
            "SOFTWARE REV # 0",
            "SOFTWARE DATE  AUG 14 2002",
            "MODEL #    P283T12T11",
            "HWDR P/N # EMULATOR",
            "SERIAL #   EMU001",
            "MANUFACTUR DATE AUG 14 2002",
            "OPTIONS LIST    NONE");
    String text = String.join("\r\n", lines);
    int blanks = LENGTH_IDENTIFICATION - AROUND_PAYLOAD - text.length();
    return frame("Cj", (text + " ".repeat(blanks)).getBytes(StandardCharsets.US_ASCII));
  }

  /** {@code @@Hb}: position and status of twelve channels, without its satellites. */
  static byte[] shortPosition(Moment moment) {
    AntennaState antenna = moment.antenna();
    ByteBuffer out = ByteBuffer.allocate(54 - AROUND_PAYLOAD);
    putTime(out, moment);
    putPosition(out, antenna.position());
    putSpeed(out, antenna.speed());
    putSpeed(out, antenna.speed());
    out.putShort((short) Math.round(antenna.course() * 10));
    out.putShort((short) moment.dilution());
    out.put((byte) moment.sky().visible()).put((byte) moment.sky().tracked(12));
    out.putShort((short) moment.status()).putShort((short) 0);
    out.put("EMU001".getBytes(StandardCharsets.US_ASCII));
    return frame("Hb", out.array());
  }

  /** {@code @@Bb}: the satellites above the horizon. */
  static byte[] visible(Moment moment) {
    ByteBuffer out = ByteBuffer.allocate(92 - AROUND_PAYLOAD);
    List<SatelliteConstellation.Channel> channels = moment.sky().channels();
    out.put((byte) channels.size());
    for (SatelliteConstellation.Channel channel : channels) {
      out.put((byte) channel.satellite()).putShort((short) 0); // no doppler
      out.put((byte) channel.elevation()).putShort((short) channel.azimuth()).put((byte) 0);
    }
    return frame("Bb", out.array());
  }

  /** {@code @@Hn}: time RAIM of twelve channels. */
  static byte[] timeRaim12(Moment moment, boolean on) {
    ByteBuffer out = ByteBuffer.allocate(78 - AROUND_PAYLOAD);
    putTimeRaim(out, moment, on);
    out.putInt(0); // no satellite excluded
    putTimeErrors(out, moment, 12);
    return frame("Hn", out.array());
  }

  /** {@code @@En}: time RAIM of eight channels. */
  static byte[] timeRaim8(Moment moment, boolean on) {
    ByteBuffer out = ByteBuffer.allocate(69 - AROUND_PAYLOAD);
    out.put((byte) 1).put((byte) (on ? 1 : 0)).putShort((short) 10).put((byte) 2);
    out.put(new byte[10]);
    putTimeRaim(out, moment, on);
    putTimeErrors(out, moment, 8);
    return frame("En", out.array());
  }

  /** Pulse, its scale, solution status, RAIM status. */
  private static void putTimeRaim(ByteBuffer out, Moment moment, boolean on) {
    boolean works = on && moment.hasFix();
    out.put((byte) 1).put((byte) (moment.isUtc() ? 0 : 1));
    out.put((byte) (works ? 0 : 2)).put((byte) (works ? 0 : 2));
  }

  /** Accuracy, sawtooth, and the time by each satellite. */
  private static void putTimeErrors(ByteBuffer out, Moment moment, int channels) {
    out.putShort((short) 54).put((byte) -7);
    for (int i = 0; i < channels; i++) {
      boolean there = i < moment.sky().channels().size();
      out.put((byte) (there ? moment.sky().channels().get(i).satellite() : 0)).putInt(0);
    }
  }

  /** {@code @@Gb}: the receiver's date and time; its offset of local time is zero. */
  static byte[] clock(Instant utc) {
    LocalDateTime time = LocalDateTime.ofInstant(utc, ZoneOffset.UTC);
    ByteBuffer out = ByteBuffer.allocate(17 - AROUND_PAYLOAD);
    out.put((byte) time.getMonthValue()).put((byte) time.getDayOfMonth());
    out.putShort((short) time.getYear());
    out.put((byte) time.getHour()).put((byte) time.getMinute()).put((byte) time.getSecond());
    return frame("Gb", out.array());
  }

  /** The date and time that {@code @@Gb} sets; null where it is invalid, which is a query. */
  static @Nullable Instant clockIn(byte[] argument) {
    ByteBuffer in = ByteBuffer.wrap(argument);
    int month = in.get();
    int day = in.get();
    try {
      return LocalDateTime.of(in.getShort(), month, day, in.get(), in.get(), in.get())
          .toInstant(ZoneOffset.UTC);
    } catch (DateTimeException e) {
      return null;
    }
  }

  /** {@code @@As}: the position to hold. */
  static byte[] held(GeoPosition position) {
    ByteBuffer out = ByteBuffer.allocate(20 - AROUND_PAYLOAD);
    out.putInt((int) Math.round(position.latitude() * 3_600_000));
    out.putInt((int) Math.round(position.longitude() * 3_600_000));
    out.putInt((int) Math.round(position.height() * 100));
    return frame("As", out.array());
  }

  /** The position that {@code @@As} sets; null where it is invalid, which is a query. */
  static @Nullable GeoPosition heldIn(byte[] argument) {
    ByteBuffer in = ByteBuffer.wrap(argument);
    double latitude = in.getInt() / 3.6e6;
    double longitude = in.getInt() / 3.6e6;
    return Math.abs(latitude) > 90 || Math.abs(longitude) > 180
        ? null
        : new GeoPosition(latitude, longitude, in.getInt() / 100.0);
  }

  /**
   * The data that a message reports.
   *
   * @param utc the time by the receiver's clock
   * @param utcOffset GPS time minus UTC, seconds; 0 while unknown
   * @param scale the time scale in which the time is reported
   * @param solution the state of its solution
   * @param antenna reported antenna state
   */
  record Moment(
      Instant utc, int utcOffset, TimeScale scale, Solution solution, AntennaState antenna) {

    /** A time scale. */
    enum TimeScale {
      UTC,
      GPS
    }

    /** The state of a receiver's solution. */
    enum Solution {
      /** It has no fix. */
      ACQUIRING,
      /** It has a fix. */
      FIX_3D,
      /** It solves for time only, at a held position. */
      POSITION_HOLD
    }

    boolean isUtc() {
      return scale == TimeScale.UTC;
    }

    boolean hasFix() {
      return solution != Solution.ACQUIRING;
    }

    SatelliteConstellation sky() {
      return hasFix() ? SatelliteConstellation.withFix(utc) : SatelliteConstellation.searching(utc);
    }

    /** Tenths; none while the position is held. */
    int dilution() {
      return solution == Solution.FIX_3D ? 18 : 0;
    }

    int status() {
      return switch (solution) {
        case ACQUIRING -> ACQUIRING | TOO_FEW_SATELLITES;
        case FIX_3D -> NARROW_BAND | FIX_3D;
        case POSITION_HOLD -> NARROW_BAND | POSITION_HOLD;
      };
    }
  }

  private static void putTime(ByteBuffer out, Moment moment) {
    Instant gps = moment.utc().plusSeconds(UTC_OFFSET);
    Instant reported = moment.isUtc() ? gps.minusSeconds(moment.utcOffset()) : gps;
    LocalDateTime time = LocalDateTime.ofInstant(reported, ZoneOffset.UTC);
    out.put((byte) time.getMonthValue()).put((byte) time.getDayOfMonth());
    out.putShort((short) time.getYear());
    out.put((byte) time.getHour()).put((byte) time.getMinute()).put((byte) time.getSecond());
    out.putInt(time.getNano());
  }

  private static void putPosition(ByteBuffer out, GeoPosition position) {
    out.putInt((int) Math.round(position.latitude() * 3_600_000));
    out.putInt((int) Math.round(position.longitude() * 3_600_000));
    out.putInt((int) Math.round(position.height() * 100));
    out.putInt(0); // height above mean sea level is not known
  }

  private static void putSpeed(ByteBuffer out, double speed) {
    out.putShort((short) Math.min(51_400, Math.round(speed * 100)));
  }

  private static void putChannel12(
      ByteBuffer out, List<SatelliteConstellation.Channel> channels, int index) {
    if (index >= channels.size()) {
      out.put(new byte[6]);
      return;
    }
    SatelliteConstellation.Channel channel = channels.get(index);
    out.put((byte) channel.satellite()).put((byte) channel.mode());
    out.put((byte) channel.carrierToNoise()).put((byte) channel.ephemerisIssue());
    out.putShort(
        (short) (channel.mode() == SatelliteConstellation.AVAILABLE ? CHANNEL_USED_12 : 0));
  }
}
