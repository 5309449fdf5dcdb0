package org.dfra.drivers.gps.nmea;

import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.time.LocalTime;
import org.jspecify.annotations.Nullable;

/** The fields of one sentence by number; 0 is talker and type. Reused for each sentence. */
final class NmeaFields {

  private static final int MOST = 64;
  private static final long[] POWERS = {
    1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000
  };
  private static final int MOST_DIGITS = 17; // roughly the longs that a double represents exactly

  private byte[] bytes = new byte[0];
  private final int[] starts = new int[MOST + 1];
  private int count;

  /** Sets the sentence, as found by {@link NmeaParser.NmeaFramer}. */
  void take(byte[] sentence, int offset, int length) {
    bytes = sentence;
    count = 0;
    starts[0] = offset + 1;
    int at = offset + 1;
    int end = offset + length;
    while (at < end && bytes[at] != '*' && bytes[at] != '\r' && bytes[at] != '\n') {
      if (bytes[at] == ',' && count + 1 < MOST) {
        count++;
        starts[count] = at + 1;
      }
      at++;
    }
    count++;
    starts[count] = at + 1;
  }

  /** Number of fields. */
  int count() {
    return count;
  }

  int start(int field) {
    return starts[field];
  }

  int length(int field) {
    return field < count ? starts[field + 1] - 1 - starts[field] : 0;
  }

  boolean isEmpty(int field) {
    return length(field) == 0;
  }

  /** The field's one character; a blank if it is empty. */
  char letter(int field) {
    return isEmpty(field) ? ' ' : (char) bytes[starts[field]];
  }

  String text(int field) {
    return new String(bytes, starts[field], length(field), StandardCharsets.US_ASCII);
  }

  /** A number within limits; NaN if it is empty. */
  double number(String what, int field, double least, double most) throws MalformedException {
    if (isEmpty(field)) {
      return Double.NaN;
    }
    double value = decimal(what, field);
    if (!(value >= least && value <= most)) {
      throw wrong(what, field, "a number from " + least + " to " + most);
    }
    return value;
  }

  /** A whole number within limits; −1 if it is empty. */
  int whole(String what, int field, int least, int most) throws MalformedException {
    if (isEmpty(field)) {
      return -1;
    }
    int end = starts[field] + length(field);
    long value = 0;
    for (int i = starts[field]; i < end; i++) {
      int digit = bytes[i] - '0';
      if (digit < 0 || digit > 9 || value > Integer.MAX_VALUE) {
        throw wrong(what, field, "a whole number");
      }
      value = 10 * value + digit;
    }
    if (value < least || value > most) {
      throw wrong(what, field, "a whole number from " + least + " to " + most);
    }
    return (int) value;
  }

  /** {@code dddmm.mmmm} and its hemisphere in the next field, as degrees; NaN if it is empty. */
  double angle(String what, int field, char negative, int most) throws MalformedException {
    if (isEmpty(field)) {
      return Double.NaN;
    }
    double value = number(what, field, 0, 100 * most);
    double degrees = Math.floor(value / 100);
    double minutes = value - 100 * degrees;
    if (minutes >= 60) {
      throw wrong(what, field, "degrees and minutes");
    }
    double angle = degrees + minutes / 60;
    return letter(field + 1) == negative ? -angle : angle;
  }

  /** {@code hhmmss.sss}; null if it is empty. A leap second is the last nanosecond before it. */
  @Nullable LocalTime time(int field) throws MalformedException {
    if (isEmpty(field)) {
      return null;
    }
    if (length(field) < 6) {
      throw wrong("time", field, "a time of day");
    }
    double value = number("time", field, 0, 235_960.999_999_999);
    long whole = (long) value;
    int nanos = (int) Math.round((value - whole) * 1e6) * 1000;
    int second = (int) (whole % 100);
    try {
      return second == 60
          ? LocalTime.of((int) (whole / 10_000), (int) (whole / 100 % 100), 59, 999_999_999)
          : LocalTime.of(
              (int) (whole / 10_000),
              (int) (whole / 100 % 100),
              second,
              Math.min(nanos, 999_999_999));
    } catch (DateTimeException e) {
      throw wrong("time", field, "a time of day");
    }
  }

  /** {@code ddmmyy} of the years 1980 to 2079; null if it is empty or zero. */
  @Nullable LocalDate date(int field) throws MalformedException {
    if (isEmpty(field)) {
      return null;
    }
    int value = whole("date", field, 0, 311_299);
    if (value == 0) {
      return null; // six zeros: unknown to the receiver
    }
    int year = value % 100;
    try {
      return LocalDate.of(year < 80 ? 2000 + year : 1900 + year, value / 100 % 100, value / 10_000);
    } catch (DateTimeException e) {
      throw wrong("date", field, "a date");
    }
  }

  /** Day, month and year of four digits in fields of their own; null if empty or zero. */
  @Nullable LocalDate date(int dayField, int monthField, int yearField) throws MalformedException {
    int day = whole("day", dayField, 0, 31);
    int month = whole("month", monthField, 0, 12);
    int year = whole("year", yearField, 0, 9999);
    if (day <= 0 || month <= 0 || year <= 0) {
      return null;
    }
    try {
      return LocalDate.of(year, month, day);
    } catch (DateTimeException e) {
      throw wrong("day", dayField, "a day of month " + month + " of " + year);
    }
  }

  /** Hours from −13 to 13 and, in the next field, minutes with the same sign, as minutes. */
  @Nullable Integer zone(int field) throws MalformedException {
    if (isEmpty(field)) {
      return null;
    }
    double hours = number("zone (h)", field, -14, 14);
    double minutes = Math.abs(number("zone (min)", field + 1, -59, 59));
    boolean east = bytes[starts[field]] == '-';
    double all = Math.abs(hours) * 60 + (Double.isNaN(minutes) ? 0 : minutes);
    return (int) Math.round(east ? -all : all);
  }

  private double decimal(String what, int field) throws MalformedException {
    int at = starts[field];
    int end = at + length(field);
    boolean negative = bytes[at] == '-';
    if (negative || bytes[at] == '+') {
      at++;
    }
    long value = 0;
    int digits = 0;
    int decimals = -1;
    for (; at < end; at++) {
      int digit = bytes[at] - '0';
      if (digit == '.' - '0' && decimals < 0) {
        decimals = 0;
      } else if (digit < 0 || digit > 9) {
        throw wrong(what, field, "a number");
      } else if (digits < MOST_DIGITS && decimals < POWERS.length - 1) {
        value = 10 * value + digit;
        digits++;
        decimals += decimals < 0 ? 0 : 1;
      } else if (decimals < 0) {
        throw wrong(what, field, "a number"); // too many digits before the point
      }
    }
    if (digits == 0) {
      throw wrong(what, field, "a number");
    }
    double number = decimals > 0 ? (double) value / POWERS[decimals] : value;
    return negative ? -number : number;
  }

  private MalformedException wrong(String what, int field, String expected) {
    return new MalformedException(
        what + " \"" + text(field) + "\" in field " + field + " is not " + expected);
  }

  /** An invalid value; never leaves the decoder. */
  static final class MalformedException extends Exception {

    private static final long serialVersionUID = 1L;

    MalformedException(String message) {
      super(message, null, false, false);
    }
  }
}
