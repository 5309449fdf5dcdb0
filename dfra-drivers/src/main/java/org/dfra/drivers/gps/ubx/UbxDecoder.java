package org.dfra.drivers.gps.ubx;

import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.gps.ubx.UbxMessage.Ack;
import org.dfra.drivers.gps.ubx.UbxMessage.Malformed;
import org.dfra.drivers.gps.ubx.UbxMessage.NavPvt;
import org.dfra.drivers.gps.ubx.UbxMessage.NavSat;
import org.dfra.drivers.gps.ubx.UbxMessage.Other;
import org.dfra.drivers.gps.ubx.UbxMessage.Satellite;
import org.dfra.drivers.gps.ubx.UbxMessage.Version;
import org.dfra.drivers.gps.ubx.UbxParser.UbxFramer;
import org.jspecify.annotations.Nullable;

/**
 * Decodes intact frames, one at a time. Pure; never throws, whatever the content of a frame: an
 * invalid value makes a {@link Malformed}.
 */
final class UbxDecoder {

  private static final int VALID_DATE_AND_TIME = 3;
  private static final int RESOLVED = 4;
  private static final int USED = 8;
  private static final int INVALID_POSITION = 1;

  private final byte[] bytes;
  private final int at; // where the payload begins
  private final int length;

  private UbxDecoder(byte[] bytes, int at, int length) {
    this.bytes = bytes;
    this.at = at;
    this.length = length;
  }

  /**
   * Decodes a frame found by {@link UbxFramer}.
   *
   * @param bytes holds it
   * @param offset index of its first byte
   * @param length its length in bytes
   */
  public static UbxMessage decode(byte[] bytes, int offset, int length) {
    int type = (bytes[offset + 2] & 0xFF) << 8 | (bytes[offset + 3] & 0xFF);
    UbxDecoder payload = new UbxDecoder(bytes, offset + UbxFramer.HEAD, length - UbxFramer.AROUND);
    return switch (type) {
      case UbxFramer.NAV_PVT -> payload.position();
      case UbxFramer.NAV_SAT -> payload.satellites();
      case UbxFramer.ACK_ACK -> new Ack(true, payload.u8(0) << 8 | payload.u8(1));
      case UbxFramer.ACK_NAK -> new Ack(false, payload.u8(0) << 8 | payload.u8(1));
      case UbxFramer.MON_VER -> payload.version();
      default -> new Other(type);
    };
  }

  private UbxMessage position() {
    double latitude = i32(28) / 1e7;
    double longitude = i32(24) / 1e7;
    double height = i32(32) / 1e3;
    int speed = i32(60);
    if (Math.abs(latitude) > 90) {
      return new Malformed("NAV-PVT", "latitude " + latitude + "° is outside −90° to 90°");
    }
    if (Math.abs(longitude) > 180) {
      return new Malformed("NAV-PVT", "longitude " + longitude + "° is outside −180° to 180°");
    }
    if (speed < 0) {
      return new Malformed("NAV-PVT", "ground speed " + speed + " mm/s is not ≥ 0");
    }
    boolean valid = (u8(11) & VALID_DATE_AND_TIME) == VALID_DATE_AND_TIME;
    Instant utc = valid ? utc() : null;
    if (valid && utc == null) {
      return new Malformed("NAV-PVT", "date and time said to be valid are not in the calendar");
    }
    double course = i32(64) / 1e5 % 360;
    return new NavPvt(
        utc,
        (u8(11) & RESOLVED) != 0,
        u8(20),
        (u8(21) & 1) != 0 && (u8(78) & INVALID_POSITION) == 0,
        u8(23),
        latitude,
        longitude,
        height,
        i32(36) / 1e3,
        u32(40) / 1e3,
        u32(44) / 1e3,
        i32(48) / 1e3,
        i32(52) / 1e3,
        i32(56) / 1e3,
        speed / 1e3,
        course < 0 ? course + 360 : course,
        u16(76) / 100.0);
  }

  /** The fraction may be negative: then the second is rounded up. */
  private @Nullable Instant utc() {
    try {
      int second = u8(10);
      LocalDateTime time =
          LocalDateTime.of(u16(4), u8(6), u8(7), u8(8), u8(9), Math.min(second, 59));
      if (second > 60) {
        return null;
      }
      Instant whole = time.toInstant(ZoneOffset.UTC);
      return second == 60 ? whole.plusNanos(999_999_999) : whole.plusNanos(i32(16));
    } catch (DateTimeException e) {
      return null;
    }
  }

  private UbxMessage satellites() {
    int count = u8(5);
    if (8 + 12 * count != length) {
      return new Malformed("NAV-SAT", count + " satellites do not fit " + length + " bytes");
    }
    List<Satellite> satellites = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      int block = 8 + 12 * i;
      satellites.add(
          new Satellite(
              u8(block),
              u8(block + 1),
              u8(block + 2),
              (byte) u8(block + 3),
              (short) u16(block + 4),
              (u8(block + 8) & USED) != 0));
    }
    return new NavSat(satellites);
  }

  private Version version() {
    List<String> extensions = new ArrayList<>();
    for (int from = 40; from < length; from += 30) {
      extensions.add(text(from, 30));
    }
    return new Version(text(0, 30), text(30, 10), extensions);
  }

  /** The text before the first zero byte. */
  private String text(int offset, int most) {
    int end = 0;
    while (end < most && bytes[at + offset + end] != 0) {
      end++;
    }
    return new String(bytes, at + offset, end, StandardCharsets.ISO_8859_1).strip();
  }

  private int u8(int offset) {
    return bytes[at + offset] & 0xFF;
  }

  private int u16(int offset) {
    return u8(offset) | u8(offset + 1) << 8;
  }

  private int i32(int offset) {
    return u16(offset) | u16(offset + 2) << 16;
  }

  private long u32(int offset) {
    return i32(offset) & 0xFFFF_FFFFL;
  }
}
