package org.dfra.drivers.gps.nmea;

import java.time.Duration;
import java.time.LocalTime;
import org.dfra.drivers.gps.nmea.NmeaSentence.Rmc;
import org.dfra.drivers.gps.nmea.NmeaSentence.Vtg;
import org.jspecify.annotations.Nullable;

/**
 * Speed and course. They come in other sentences than the position, and many receivers send them
 * less often. They are valid for {@link #MAX_AGE}, by the receiver's own time. Confined to one
 * thread.
 */
final class NmeaMotion {

  /** How long they are valid. */
  static final Duration MAX_AGE = Duration.ofSeconds(2);

  private static final Duration DAY = Duration.ofDays(1);

  private double speed = Double.NaN;
  private double course = Double.NaN;
  private @Nullable LocalTime reported;

  void forget() {
    speed = Double.NaN;
    course = Double.NaN;
    reported = null;
  }

  /** Takes speed and course from {@code RMC}; they are unknown where it is marked invalid. */
  void take(Rmc rmc) {
    if (!rmc.valid() || rmc.mode() == 'N') {
      forget();
    } else if (!Double.isNaN(rmc.speed())) {
      set(rmc.speed(), rmc.course(), rmc.time());
    }
  }

  /**
   * Takes speed and course from {@code VTG}.
   *
   * @param time the time that it belongs to; null if unknown
   */
  void take(Vtg vtg, @Nullable LocalTime time) {
    if (vtg.mode() == 'N') {
      forget();
    } else if (!Double.isNaN(vtg.speed())) {
      set(vtg.speed(), vtg.course(), time);
    }
  }

  private void set(double newSpeed, double newCourse, @Nullable LocalTime time) {
    speed = newSpeed;
    course = newCourse;
    reported = time;
  }

  /**
   * Drops values that are too old at that time of day; values without a known time are dropped too.
   */
  void expire(@Nullable LocalTime now) {
    LocalTime then = reported;
    if (now == null || then == null) {
      forget();
      return;
    }
    Duration age = Duration.between(then, now);
    if ((age.isNegative() ? age.plus(DAY) : age).compareTo(MAX_AGE) > 0) {
      forget();
    }
  }

  /** Over ground, metres per second; NaN if it is not known. */
  double speed() {
    return speed;
  }

  /** Degrees, 0 is true north, clockwise is +; NaN if it is not known. */
  double course() {
    return course;
  }
}
