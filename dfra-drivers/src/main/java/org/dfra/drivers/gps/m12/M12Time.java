package org.dfra.drivers.gps.m12;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.ZoneOffset;

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
public record M12Time(LocalDate date, int hour, int minute, int second, int nanos) {

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
