package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.List;
import org.dfra.geometry.GeoPosition;

/**
 * Writes the frames a receiver sends. Source: Motorola Oncore M12+ user's guide.
 *
 * <p>Pure functions; numbers have their highest byte first.
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
  static byte[] position12(Instant utc, boolean tellsUtc, boolean hasFix, AntennaState antenna) {
    Sky sky = hasFix ? Sky.found(utc) : Sky.searching(utc);
    ByteBuffer out = ByteBuffer.allocate(LENGTH_12 - AROUND_PAYLOAD);
    putTime(out, utc, tellsUtc);
    putPosition(out, antenna.position()); // filtered
    putPosition(out, antenna.position()); // unfiltered
    putSpeed(out, antenna.speed()); // 3-D: the height is constant
    putSpeed(out, antenna.speed());
    out.putShort((short) Math.round(antenna.course() * 10));
    out.putShort((short) (hasFix ? 18 : 0));
    out.put((byte) sky.visible()).put((byte) sky.tracked(12));
    for (int i = 0; i < 12; i++) {
      putChannel12(out, sky.channels(), i);
    }
    out.putShort((short) (hasFix ? FIX_3D | NARROW_BAND : ACQUIRING | TOO_FEW_SATELLITES));
    out.putShort((short) 0).putShort((short) -12).putInt(99_800); // reserved, bias, oscillator
    out.putShort((short) 56); // 28 °C
    out.put((byte) ((tellsUtc ? 0x80 : 0) | 0x40 | UTC_OFFSET));
    out.put((byte) 0).put((byte) 0).put((byte) 0); // local time is UTC
    out.put("EMU001".getBytes(StandardCharsets.US_ASCII));
    return frame("Ha", out.array());
  }

  /** {@code @@Ea}: position, status and data of eight channels. */
  static byte[] position8(Instant utc, boolean tellsUtc, boolean hasFix, AntennaState antenna) {
    Sky sky = hasFix ? Sky.found(utc) : Sky.searching(utc);
    ByteBuffer out = ByteBuffer.allocate(LENGTH_8 - AROUND_PAYLOAD);
    putTime(out, utc, tellsUtc);
    putPosition(out, antenna.position());
    putSpeed(out, antenna.speed());
    out.putShort((short) Math.round(antenna.course() * 10));
    out.putShort((short) (hasFix ? 18 : 0));
    out.put((byte) 0); // PDOP, antenna in order
    out.put((byte) sky.visible()).put((byte) sky.tracked(8));
    for (Sky.Channel channel : sky.channels().subList(0, 8)) {
      out.put((byte) channel.satellite()).put((byte) channel.mode());
      out.put((byte) channel.carrierToNoise());
      out.put((byte) (channel.mode() == Sky.AVAILABLE ? CHANNEL_USED_8 : 0));
    }
    out.put((byte) (hasFix ? 0x20 : 0x08 | 0x02));
    return frame("Ea", out.array());
  }

  /** {@code @@Cj}: what the receiver is, in lines of text. */
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

  private static void putTime(ByteBuffer out, Instant utc, boolean tellsUtc) {
    Instant told = tellsUtc ? utc : utc.plusSeconds(UTC_OFFSET);
    LocalDateTime time = LocalDateTime.ofInstant(told, ZoneOffset.UTC);
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

  private static void putChannel12(ByteBuffer out, List<Sky.Channel> channels, int index) {
    if (index >= channels.size()) {
      out.put(new byte[6]);
      return;
    }
    Sky.Channel channel = channels.get(index);
    out.put((byte) channel.satellite()).put((byte) channel.mode());
    out.put((byte) channel.carrierToNoise()).put((byte) channel.ephemerisIssue());
    out.putShort((short) (channel.mode() == Sky.AVAILABLE ? CHANNEL_USED_12 : 0));
  }
}
