package org.dfra.sim.device.gps;

import java.time.Duration;
import java.time.Instant;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Wgs84;

/** Motion of a receiver's antenna over time. The emulator's thread queries it. */
@FunctionalInterface
public interface AntennaTrajectory {

  /** The antenna's state at {@code time}. */
  AntennaState at(Instant time);

  /** Whether enough satellites are tracked at {@code time} for a position. */
  default boolean hasSatellites(Instant time) {
    return true;
  }

  /** A stationary antenna. */
  static AntennaTrajectory fixed(GeoPosition position) {
    AntennaState state = new AntennaState(position, 0, 0);
    return time -> state;
  }

  /**
   * Moves at a constant velocity and height, as a drifting boat does. Uses the WGS84 radii of
   * curvature at the start: valid for paths of a few kilometres, away from the poles.
   *
   * @param from position at {@code begin}
   * @param begin time of that position
   * @param north velocity towards north, metres per second
   * @param east velocity towards east, metres per second
   */
  static AntennaTrajectory constantVelocity(
      GeoPosition from, Instant begin, double north, double east) {
    double meridianRadius = Wgs84.meridianRadius(from.latitude()) + from.height();
    double parallelRadius =
        (Wgs84.primeVerticalRadius(from.latitude()) + from.height())
            * Math.cos(Math.toRadians(from.latitude()));
    double degreesNorth = Math.toDegrees(north / meridianRadius);
    double degreesEast = Math.toDegrees(east / parallelRadius);
    double speed = Math.hypot(north, east);
    double degrees = Math.toDegrees(Math.atan2(east, north));
    double course = degrees < 0 ? degrees + 360 : degrees;
    return time -> {
      double seconds = Duration.between(begin, time).toNanos() / 1e9;
      GeoPosition position =
          new GeoPosition(
              Math.max(-90, Math.min(90, from.latitude() + degreesNorth * seconds)),
              Math.IEEEremainder(from.longitude() + degreesEast * seconds, 360),
              from.height());
      return new AntennaState(position, speed, course);
    };
  }

  /**
   * Position and velocity of a receiver's antenna.
   *
   * @param position of the antenna, frame WGS84
   * @param speed over ground, metres per second, not negative
   * @param course direction of travel, degrees, 0 to less than 360, 0 is true north, clockwise is +
   */
  record AntennaState(GeoPosition position, double speed, double course) {

    public AntennaState {
      if (!(speed >= 0)) {
        throw new IllegalArgumentException("speed " + speed + " m/s is not ≥ 0");
      }
      if (!(course >= 0 && course < 360)) {
        throw new IllegalArgumentException(
            "course " + course + "° is outside 0° to less than 360°");
      }
    }
  }
}
