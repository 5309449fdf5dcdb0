package org.dfra.drivers.gps.m12;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.List;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;

/** A message with position, time and satellites. */
public sealed interface M12PositionMessage extends M12Message
    permits Position12Channels, M12PositionMessage.ShortPosition, Position8Channels {

  /** Date and time of the solution, in the scale the receiver is set to. */
  M12Time time();

  /** The position: filtered where the receiver filters. Old or zero where the mode is NONE. */
  M12Position position();

  /** Speed over ground, metres per second. */
  double groundSpeed();

  /** Direction of travel, degrees, 0 is true north, clockwise is +. */
  double heading();

  /** Dilution of precision, without unit: PDOP for 3-D, HDOP for 2-D, 0 for a held position. */
  double dilution();

  /** Satellites above the horizon by the almanac; may exceed the channels. */
  int visible();

  /** Satellites locked on. */
  int tracked();

  /** The state of every channel, in the receiver's order. */
  List<SatelliteChannel> channels();

  /** What was solved for. */
  GpsFix.Mode mode();

  /** The receiver's state as human-readable text, for an operator who waits for a position. */
  String stateInWords();

  /**
   * The time as UTC. Where {@link #knowsUtc} is false it may be GPS time, which is ahead of UTC by
   * the leap seconds since 1980 (18 s since 2017).
   */
  Instant utc();

  /** Whether {@link #utc} is confirmed as UTC by this message. */
  boolean knowsUtc();

  /** Converts the message to a fix, from this message alone. */
  default GpsFix toFix() {
    return toFix(mode(), utc());
  }

  /**
   * Converts the message to a fix, with data from other messages.
   *
   * @param mode what was solved for
   * @param utc time of the solution
   */
  default GpsFix toFix(GpsFix.Mode mode, Instant utc) {
    return new GpsFix(
        mode,
        mode == GpsFix.Mode.NONE ? null : position().toGeoPosition(),
        utc,
        groundSpeed(),
        heading(),
        dilution(),
        visible(),
        tracked());
  }

  /**
   * {@code @@Hb}: position and status of a twelve-channel receiver in a third of the bytes of
   * {@code @@Ha}; it contains no satellites, and not whether its time is UTC. Source: Motorola
   * Oncore M12+ user's guide.
   *
   * @param time date and time of the solution
   * @param position the position
   * @param speed3d speed in space, metres per second
   * @param groundSpeed speed over ground (2-D), metres per second
   * @param heading direction of travel, degrees, 0 to 360, 0 is true north, clockwise is +
   * @param dilution PDOP for a 3-D fix, HDOP for a 2-D one, 0 in position hold
   * @param visible satellites above the horizon by the almanac; may exceed 12
   * @param tracked satellites locked on, 0 to 12
   * @param status the receiver's state
   * @param idTag the six letters stored in the receiver for its owner
   */
  record ShortPosition(
      M12Time time,
      M12Position position,
      double speed3d,
      double groundSpeed,
      double heading,
      double dilution,
      int visible,
      int tracked,
      ReceiverStatus status,
      String idTag)
      implements M12PositionMessage {

    @Override
    public String id() {
      return "Hb";
    }

    @Override
    public List<SatelliteChannel> channels() {
      return List.of();
    }

    @Override
    public GpsFix.Mode mode() {
      return status.mode();
    }

    @Override
    public String stateInWords() {
      return status.inWords(tracked, visible);
    }

    @Override
    public Instant utc() {
      return time.toInstant();
    }

    /**
     * {@inheritDoc} Always false for this message alone; {@code @@Bo} and {@code @@Aw} report it.
     */
    @Override
    public boolean knowsUtc() {
      return false;
    }
  }

  /**
   * State of one of the receiver's channels.
   *
   * @param satellite number of the satellite (SV id, PRN), 1 to 37; 0 when the channel is idle
   * @param mode tracking mode: 0 code search, 1 code acquire, 2 automatic gain, 3 preposition
   *     acquire, 4 bit sync, 5 message sync, 6 satellite time, 7 ephemeris, 8 available for
   *     position
   * @param carrierToNoise strength of the signal, dB-Hz (C/No)
   * @param ephemerisIssue issue of the ephemeris (IODE); −1 where the message does not contain it
   * @param status the channel's raw status bits: 16 bits in {@code @@Ha}, 8 in {@code @@Ea}
   */
  record SatelliteChannel(
      int satellite, int mode, int carrierToNoise, int ephemerisIssue, int status) {

    /** Whether the receiver may use this satellite for its position. */
    public boolean isAvailable() {
      return mode == 8;
    }
  }

  /**
   * The receiver's knowledge of UTC.
   *
   * @param isUtc whether it reports UTC; otherwise GPS time
   * @param isKnown whether it has received the offset from the satellites; takes up to 12.5 minutes
   *     after a cold start
   * @param offset GPS time minus UTC, seconds, −32 to 31
   */
  record UtcState(boolean isUtc, boolean isKnown, int offset) {

    static UtcState of(int bits) {
      return new UtcState((bits & 0x80) != 0, (bits & 0x40) != 0, (bits & 0x3F) << 26 >> 26);
    }
  }

  /**
   * A position in the receiver's format, frame WGS84.
   *
   * @param latitude degrees, −90 to 90, north is +
   * @param longitude degrees, −180 to 180, east is +
   * @param height above the WGS84 ellipsoid, metres
   * @param heightMsl above mean sea level, metres; the M12+ does not know it and always reports 0
   */
  record M12Position(double latitude, double longitude, double height, double heightMsl) {

    /** The position with its ellipsoidal height. */
    public GeoPosition toGeoPosition() {
      return new GeoPosition(latitude, longitude, height);
    }
  }

  /**
   * Date and time in the receiver's format. The message determines whether it is UTC or GPS time.
   *
   * <p>A receiver whose firmware has outlived its GPS week count is wrong by 1024 weeks; {@link
   * org.dfra.drivers.gps.WeekRollover} corrects that, not this class.
   *
   * @param date the date
   * @param hour 0 to 23
   * @param minute 0 to 59
   * @param second 0 to 60, where 60 is a leap second
   * @param nanos nanoseconds, 0 to 999 999 999
   */
  record M12Time(LocalDate date, int hour, int minute, int second, int nanos) {

    /** GPS time begins on 6 January 1980; an earlier date cannot come from a receiver. */
    private static final int FIRST_YEAR = 1980;

    /**
     * @throws DateTimeException if a value is out of its range
     */
    public M12Time {
      check("year", date.getYear(), FIRST_YEAR, 9999);
      check("hour", hour, 0, 23);
      check("minute", minute, 0, 59);
      check("second", second, 0, 60);
      check("fraction (ns)", nanos, 0, 999_999_999);
    }

    /**
     * The same time on Java's scale, which has no leap seconds: during one it stays at the last
     * nanosecond of the minute.
     */
    public Instant toInstant() {
      boolean leap = second == 60;
      return LocalDateTime.of(
              date.getYear(),
              date.getMonth(),
              date.getDayOfMonth(),
              hour,
              minute,
              leap ? 59 : second,
              leap ? 999_999_999 : nanos)
          .toInstant(ZoneOffset.UTC);
    }

    private static void check(String what, int value, int min, int max) {
      if (value < min || value > max) {
        throw new DateTimeException(what + " " + value + " is outside " + min + " to " + max);
      }
    }
  }
}
