package org.dfra.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Our geodesy against GeographicLib's, which knows geodesics and no planes, to 15 nm. What a plane
 * differs from them by is bounded by series; what remains is the accuracy reached: 0.1 µm within
 * 100 m, everywhere.
 */
class GeodesyTest {

  /** The least radius of curvature there is, at the equator along the meridian, metres. */
  private static final double LEAST_RADIUS = 6_335_439;

  /** What both libraries may round, metres. */
  private static final double ROUNDED = 1e-7;

  /**
   * A geodesic of length s ends in the plane at (s sin a, s cos a), but for s³/6R² along and half
   * of that times the flattening across.
   */
  @ParameterizedTest
  @CsvSource({
    "any place, -90, 90, -180, 180",
    "near the north pole, 89.99, 90, -180, 180",
    "near the south pole, -90, -89.99, -180, 180",
    "east of the antimeridian, -80, 80, -180, -179.995",
    "west of the antimeridian, -80, 80, 179.995, 180",
    "on the equator, -0.01, 0.01, -180, 180"
  })
  void agreesWithGeographicLibBothWays(
      String where, double south, double north, double west, double east) {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 2000; i++) {
      double latitude = south + random.nextDouble() * (north - south);
      double longitude = west + random.nextDouble() * (east - west);
      double azimuth = random.nextDouble() * 360;
      double s = Math.pow(10, random.nextDouble() * 4 - 1); // 0.1 m to 1 km
      String what =
          "-Ddfra.seed=%d, %s: %s m to %s° from %s°, %s°"
              .formatted(seed, where, s, azimuth, latitude, longitude);
      GeodesicData end = Geodesic.WGS84.Direct(latitude, longitude, azimuth, s);
      LocalFrame frame = new LocalFrame(new GeoPosition(latitude, longitude, 0));
      LocalPosition local =
          frame.toLocal(new GeoPosition(end.lat2, Math.IEEEremainder(end.lon2, 360), 0));
      double bend = s * s * s / (6 * LEAST_RADIUS * LEAST_RADIUS) + ROUNDED;
      assertThat(local.east())
          .as("east, %s", what)
          .isCloseTo(s * Math.sin(Math.toRadians(azimuth)), within(bend));
      assertThat(local.north())
          .as("north, %s", what)
          .isCloseTo(s * Math.cos(Math.toRadians(azimuth)), within(bend));

      GeoPosition back = frame.toGeo(local);
      double off =
          Geodesic.WGS84.Inverse(
                  end.lat2, end.lon2, back.latitude(), back.longitude(), GeodesicMask.DISTANCE)
              .s12;
      assertThat(off).as("back on the earth, %s", what).isLessThan(ROUNDED);
      assertThat(back.height()).as("height, %s", what).isCloseTo(0, within(ROUNDED));
    }
  }

  /** The chord under a geodesic of length s is shorter than it by s³/24R², and never longer. */
  @Test
  void distancesAreThoseOfGeographicLibLessTheBendOfTheEarth() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 5000; i++) {
      double latitude = Math.toDegrees(Math.asin(2 * random.nextDouble() - 1));
      double longitude = random.nextBoolean() ? 180 : random.nextDouble() * 360 - 180;
      double s = Math.pow(10, random.nextDouble() * 6 - 1); // 0.1 m to 100 km
      GeodesicData end = Geodesic.WGS84.Direct(latitude, longitude, random.nextDouble() * 360, s);
      double distance =
          new GeoPosition(latitude, longitude, 500 * random.nextDouble())
              .groundDistance(new GeoPosition(end.lat2, Math.IEEEremainder(end.lon2, 360), 0));
      double bend = s * s * s / (24 * LEAST_RADIUS * LEAST_RADIUS);
      assertThat(distance)
          .as("-Ddfra.seed=%d, %s m from %s°, %s°", seed, s, latitude, longitude)
          .isBetween(s - bend - ROUNDED, s + ROUNDED);
    }
  }
}
