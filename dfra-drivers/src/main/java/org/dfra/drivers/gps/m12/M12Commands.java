package org.dfra.drivers.gps.m12;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import org.dfra.drivers.gps.m12.M12Message.PositionControl;
import org.dfra.drivers.gps.m12.M12Message.PositionHoldMode;

/** Commands to the receiver, as the bytes to be sent. Source: Motorola Oncore M12+ user's guide. */
public final class M12Commands {

  private M12Commands() {}

  /**
   * {@code @@Ha}: position, status and satellites of twelve channels.
   *
   * @param rate seconds from one message to the next, 1 to 255; 0 for one message now and no more
   */
  public static byte[] positionOf12Channels(int rate) {
    return encode("Ha", checkedRate(rate));
  }

  /**
   * {@code @@Ea}: position, status and satellites of eight channels, as older receivers send it.
   *
   * @param rate as for {@link #positionOf12Channels}
   */
  public static byte[] positionOf8Channels(int rate) {
    return encode("Ea", checkedRate(rate));
  }

  /** {@code @@Cj}: requests the receiver's identification. */
  public static byte[] identification() {
    return encode("Cj");
  }

  /**
   * {@code @@Cf}: resets to factory defaults, with no messages enabled. Acknowledged with the same
   * ID.
   */
  public static byte[] defaults() {
    return encode("Cf");
  }

  /**
   * {@code @@Hb}: the short position message.
   *
   * @param rate as for {@link #positionOf12Channels}
   */
  public static byte[] shortPosition(int rate) {
    return encode("Hb", checkedRate(rate));
  }

  /**
   * {@code @@Bb}: the satellites above the horizon, whenever they change.
   *
   * @param on whether to report changes; otherwise one message now and no more
   */
  public static byte[] visibleSatellites(boolean on) {
    return encode("Bb", on ? 1 : 0);
  }

  /**
   * {@code @@Hn}: time RAIM of twelve channels.
   *
   * @param rate as for {@link #positionOf12Channels}
   */
  public static byte[] timeRaimOf12Channels(int rate) {
    return encode("Hn", checkedRate(rate));
  }

  /** {@code @@Ge}: enables time RAIM (1). */
  public static byte[] timeRaimOn() {
    return encode("Ge", 1);
  }

  /**
   * {@code @@En}: time RAIM of eight channels, enabled, with an alarm limit of 1 µs and a pulse
   * whenever a satellite is tracked.
   *
   * @param rate as for {@link #positionOf12Channels}
   */
  public static byte[] timeRaimOf8Channels(int rate) {
    return encode("En", checkedRate(rate), 1, 0, 10, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  /** {@code @@Gd}: sets what to solve for. Acknowledged with the same ID. */
  public static byte[] positionControl(PositionControl.Mode mode) {
    return encode("Gd", mode.ordinal());
  }

  /**
   * {@code @@At}: sets what to solve for; for receivers of eight channels, which have no
   * {@code @@Gd}. Acknowledged with the same ID.
   */
  public static byte[] positionHold(PositionHoldMode.Mode mode) {
    return encode("At", mode.ordinal());
  }

  /** {@code @@At}: queries whether the position is held. A mode out of range makes a query. */
  public static byte[] askPositionHold() {
    return encode("At", 0xFF);
  }

  /** {@code @@As}: queries the position for position hold. */
  public static byte[] askHoldPosition() {
    int[] out = new int[13];
    out[0] = 0x7F; // latitude, longitude and height out of range
    out[4] = 0x7F;
    out[8] = 0x7F;
    out[1] = out[2] = out[3] = out[5] = out[6] = out[7] = out[9] = out[10] = out[11] = 0xFF;
    out[12] = 0xFF;
    return encode("As", out);
  }

  /**
   * {@code @@Gb}: sets date and time, for a receiver that has just been switched on. A receiver
   * that tracks satellites ignores it. Acknowledged with the same ID.
   *
   * @param time the time; the receiver takes whole seconds
   */
  public static byte[] time(Instant time) {
    LocalDateTime utc = LocalDateTime.ofInstant(time, ZoneOffset.UTC);
    return encode(
        "Gb",
        utc.getMonthValue(),
        utc.getDayOfMonth(),
        utc.getYear() >> 8,
        utc.getYear(),
        utc.getHour(),
        utc.getMinute(),
        utc.getSecond(),
        0,
        0,
        0);
  }

  /** {@code @@Bo}: queries GPS time minus UTC. Reported whenever it changes. */
  public static byte[] utcOffset() {
    return encode("Bo", 1);
  }

  /** {@code @@Aw}: sets the reported time scale to UTC (1), not GPS time (0). */
  public static byte[] utcTime() {
    return encode("Aw", 1);
  }

  /**
   * Encodes a frame.
   *
   * @param id the two letters
   * @param payload its bytes; only the low eight bits of each are used
   */
  public static byte[] encode(String id, int... payload) {
    byte[] frame = new byte[payload.length + 7];
    frame[0] = '@';
    frame[1] = '@';
    frame[2] = (byte) id.charAt(0);
    frame[3] = (byte) id.charAt(1);
    for (int i = 0; i < payload.length; i++) {
      frame[4 + i] = (byte) payload[i];
    }
    frame[frame.length - 3] = checksum(frame, 2, frame.length - 3);
    frame[frame.length - 2] = '\r';
    frame[frame.length - 1] = '\n';
    return frame;
  }

  /** The exclusive or of the bytes from {@code from} to before {@code to}. */
  static byte checksum(byte[] bytes, int from, int to) {
    byte sum = 0;
    for (int i = from; i < to; i++) {
      sum ^= bytes[i];
    }
    return sum;
  }

  private static int checkedRate(int rate) {
    if (rate < 0 || rate > 255) {
      throw new IllegalArgumentException("rate " + rate + " s is outside 0 to 255 s");
    }
    return rate;
  }
}
