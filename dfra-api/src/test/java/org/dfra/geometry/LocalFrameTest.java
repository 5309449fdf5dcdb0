package org.dfra.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import org.junit.jupiter.api.Test;

class LocalFrameTest {

  @Test
  void theDatumIsZero() {
    LocalPosition zero =
        new LocalFrame(new GeoPosition(52, 7, 50)).toLocal(new GeoPosition(52, 7, 50));
    assertThat(Math.hypot(Math.hypot(zero.east(), zero.north()), zero.up())).isLessThan(1e-9);
  }

  @Test
  void heightIsUp() {
    LocalPosition above =
        new LocalFrame(new GeoPosition(-33, 151, 10)).toLocal(new GeoPosition(-33, 151, 25));
    assertThat(above.up()).isCloseTo(15, within(1e-8));
    assertThat(Math.hypot(above.east(), above.north())).isLessThan(1e-8);
  }

  /**
   * GeographicLib walks s metres along a geodesic from the datum. In the plane that touches there
   * the end is at (s sin a, s cos a), but for s³/6R² (4 µm at 1 km), since the earth bends away,
   * and s²/2R lower; R lies between 6335 and 6400 km, so that is known to 1 %.
   */
  @Test
  void agreesWithGeographicLibWithinAKilometre() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 1000; i++) {
      double latitude = random.nextDouble() * 170 - 85;
      double longitude = random.nextDouble() * 358 - 179;
      double azimuth = random.nextDouble() * 360;
      double s = 1 + random.nextDouble() * 999;
      GeodesicData end = Geodesic.WGS84.Direct(latitude, longitude, azimuth, s);
      LocalPosition local =
          new LocalFrame(new GeoPosition(latitude, longitude, 0))
              .toLocal(new GeoPosition(end.lat2, wrapped(end.lon2), 0));
      double chord = s * s * s / (6 * 6.33e6 * 6.33e6) + 1e-6;
      assertThat(local.east())
          .as("-Ddfra.seed=%d, east at %f° %f°", seed, latitude, longitude)
          .isCloseTo(s * Math.sin(Math.toRadians(azimuth)), within(chord));
      assertThat(local.north())
          .as("-Ddfra.seed=%d, north", seed)
          .isCloseTo(s * Math.cos(Math.toRadians(azimuth)), within(chord));
      assertThat(local.up())
          .as("-Ddfra.seed=%d, up", seed)
          .isBetween(-s * s / (2 * 6.33e6) - 1e-6, -s * s / (2 * 6.41e6) + 1e-6);
    }
  }

  /** A double holds degrees to 2e-14, which is 2 nm on the ground; ten such steps are left here. */
  @Test
  void comesBackToWhereItWas() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 1000; i++) {
      GeoPosition datum =
          new GeoPosition(
              random.nextDouble() * 178 - 89,
              random.nextDouble() * 360 - 180,
              random.nextDouble() * 3000);
      LocalFrame frame = new LocalFrame(datum);
      LocalPosition there =
          new LocalPosition(
              random.nextDouble() * 20_000 - 10_000,
              random.nextDouble() * 20_000 - 10_000,
              random.nextDouble() * 1000);
      LocalPosition back = frame.toLocal(frame.toGeo(there));
      assertThat(
              Math.hypot(
                  Math.hypot(back.east() - there.east(), back.north() - there.north()),
                  back.up() - there.up()))
          .as("-Ddfra.seed=%d, %s from %s", seed, there, datum)
          .isLessThan(2e-8);
    }
  }

  private static double wrapped(double longitude) {
    return Math.IEEEremainder(longitude, 360);
  }
}
