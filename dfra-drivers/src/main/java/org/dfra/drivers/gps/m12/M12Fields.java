package org.dfra.drivers.gps.m12;

import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.LocalDate;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Position;
import org.dfra.drivers.gps.m12.M12PositionMessage.M12Time;

/** The fields of one frame, by their offsets from the first {@code @}. */
record M12Fields(byte[] bytes, int start) {

  /** Milli-arc-seconds in a degree. */
  private static final double PER_DEGREE = 3_600_000;

  /** Range of heights that the receiver can report, centimetres: −1 km to 18 km. */
  private static final int LOWEST = -100_000;

  private static final int HIGHEST = 1_800_000;

  int u8(int offset) {
    return bytes[start + offset] & 0xFF;
  }

  int u16(int offset) {
    return u8(offset) << 8 | u8(offset + 1);
  }

  int i16(int offset) {
    return (short) u16(offset);
  }

  int i32(int offset) {
    return u16(offset) << 16 | u16(offset + 2);
  }

  long u32(int offset) {
    return i32(offset) & 0xFFFF_FFFFL;
  }

  String text(int offset, int length) {
    return new String(bytes, start + offset, length, StandardCharsets.US_ASCII).strip();
  }

  int within(String what, int value, int min, int max) throws MalformedException {
    if (value < min || value > max) {
      throw new MalformedException(what + " " + value + " is outside " + min + " to " + max);
    }
    return value;
  }

  /** Date and time at offsets 4 to 14, as in all position messages. */
  M12Time time() throws MalformedException {
    return time(u32(11));
  }

  /** Date and time at offsets 4 to 10, to the second. */
  M12Time clock() throws MalformedException {
    return time(0);
  }

  private M12Time time(long nanos) throws MalformedException {
    try {
      return new M12Time(
          LocalDate.of(u16(6), u8(4), u8(5)),
          u8(8),
          u8(9),
          u8(10),
          (int) Math.min(nanos, Integer.MAX_VALUE));
    } catch (DateTimeException e) {
      throw new MalformedException(String.valueOf(e.getMessage()));
    }
  }

  /** Sign (zero is +), hours and minutes of an offset, as minutes. */
  int localOffset(int offset) {
    return (u8(offset) == 0 ? 1 : -1) * (60 * u8(offset + 1) + u8(offset + 2));
  }

  /** Latitude, longitude and a height above the ellipsoid (type 0) or mean sea level (type 1). */
  M12Position heldPosition() throws MalformedException {
    int height = within("height (cm)", i32(12), LOWEST, HIGHEST);
    boolean isEllipsoid = within("type of height", u8(16), 0, 1) == 0;
    return new M12Position(
        within("latitude (mas)", i32(4), -324_000_000, 324_000_000) / PER_DEGREE,
        within("longitude (mas)", i32(8), -648_000_000, 648_000_000) / PER_DEGREE,
        isEllipsoid ? height / 100.0 : Double.NaN,
        isEllipsoid ? 0 : height / 100.0);
  }

  /** Latitude, longitude, GPS height and MSL height, four bytes each. */
  M12Position position(int offset) throws MalformedException {
    int latitude = within("latitude (mas)", i32(offset), -324_000_000, 324_000_000);
    int longitude = within("longitude (mas)", i32(offset + 4), -648_000_000, 648_000_000);
    int height = within("GPS height (cm)", i32(offset + 8), LOWEST, HIGHEST);
    return new M12Position(
        latitude / PER_DEGREE, longitude / PER_DEGREE, height / 100.0, i32(offset + 12) / 100.0);
  }

  /** Centimetres per second; the receiver works up to 515 m/s. */
  double speed(int offset) throws MalformedException {
    return within("speed (cm/s)", u16(offset), 0, 51_500) / 100.0;
  }

  /** Tenths of a degree. */
  double heading(int offset) throws MalformedException {
    return within("heading (0.1°)", u16(offset), 0, 3600) / 10.0;
  }

  /** Tenths; maximum 99.9. */
  double dilution(int offset) throws MalformedException {
    return within("dilution (0.1)", u16(offset), 0, 999) / 10.0;
  }

  /** An invalid value; never leaves the decoder. */
  static final class MalformedException extends Exception {

    private static final long serialVersionUID = 1L;

    MalformedException(String message) {
      super(message, null, false, false);
    }
  }
}
