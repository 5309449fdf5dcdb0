package org.dfra.drivers.gps.nmea;

import java.time.Duration;
import java.time.LocalTime;
import org.dfra.drivers.gps.nmea.NmeaSentence.Rmc;
import org.dfra.drivers.gps.nmea.NmeaSentence.Vtg;
import org.jspecify.annotations.Nullable;

/**
 * Speed and course, which other sentences have than the position, and which many receivers send
 * less often: the last ones count for {@link #MAX_AGE}, by the receiver's own time. Confined to one
 * thread.
 */
final class NmeaMotion {

  /** How long they count. */
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

  /**
   * Takes what {@code RMC} says; of one that the receiver does not stand by, that it is unknown.
   */
  void take(Rmc rmc) {
    if (!rmc.valid() || rmc.mode() == 'N') {
      forget();
    } else if (!Double.isNaN(rmc.speed())) {
      set(rmc.speed(), rmc.course(), rmc.time());
    }
  }

  /**
   * Takes what {@code VTG} says.
   *
   * @param time the moment it belongs to; null if that is not known
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

  /** Drops what is too old at that time of day; without the time of either nothing is kept. */
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
