package org.dfra.sim.device;

import java.time.Duration;
import java.time.Instant;
import org.dfra.geometry.GeoPosition;

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
