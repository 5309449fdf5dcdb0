package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import org.dfra.geometry.GeoPosition;

/** Where a receiver's antenna is at any time. Asked by the emulator's thread. */
@FunctionalInterface
public interface AntennaTrajectory {

  /** Where it is at {@code time}. */
  AntennaState at(Instant time);

  /** Whether it hears enough satellites at {@code time} for a position. */
  default boolean hasSatellites(Instant time) {
    return true;
  }

  /** Stands still. */
  static AntennaTrajectory fixed(GeoPosition position) {
    AntennaState state = new AntennaState(position, 0, 0);
    return time -> state;
  }

  /**
   * Moves at a constant velocity and height, as a drifting boat does. By the radii of curvature of
   * the WGS84 ellipsoid at the start, so for paths of a few kilometres, away from the poles.
   *
   * @param from where it is at {@code begin}
   * @param begin when it is there
   * @param north velocity towards north, metres per second
   * @param east velocity towards east, metres per second
   */
  static AntennaTrajectory constantVelocity(
      GeoPosition from, Instant begin, double north, double east) {
    double semiMajor = 6_378_137; // metres
    double eccentricitySquared = 6.694379990141e-3;
    double latitude = Math.toRadians(from.latitude());
    double w = 1 - eccentricitySquared * Math.pow(Math.sin(latitude), 2);
    double meridianRadius = semiMajor * (1 - eccentricitySquared) / Math.pow(w, 1.5);
    double parallelRadius = (semiMajor / Math.sqrt(w) + from.height()) * Math.cos(latitude);
    double degreesNorth = Math.toDegrees(north / (meridianRadius + from.height()));
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
}
