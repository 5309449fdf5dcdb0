package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.junit.jupiter.api.Test;

class AntennaTrajectoryTest {

  private static final Instant BEGIN = Instant.parse("2026-01-21T07:00:00Z");

  @Test
  void standsStill() {
    GeoPosition place = new GeoPosition(1, 2, 3);
    AntennaState later = AntennaTrajectory.fixed(place).at(BEGIN.plusSeconds(1000));
    assertThat(later).isEqualTo(new AntennaState(place, 0, 0));
  }

  @Test
  void driftsByMetresPerSecond() {
    GeoPosition place = new GeoPosition(45, 10, 0);
    AntennaState after =
        AntennaTrajectory.constantVelocity(place, BEGIN, 0.3, -0.4).at(BEGIN.plusSeconds(1000));
    // At 45° a degree of latitude is 111 132 m, one of longitude 78 847 m (WGS84 tables); the
    // tables are rounded to a metre, hence 1e-5 of the way.
    assertThat((after.position().latitude() - 45) * 111_132).isCloseTo(300, within(0.01));
    assertThat((after.position().longitude() - 10) * 78_847).isCloseTo(-400, within(0.01));
    assertThat(after.speed()).isCloseTo(0.5, within(1e-12));
    assertThat(after.course()).isCloseTo(306.8699, within(1e-4)); // atan(4/3) west of north
  }

  @Test
  void crossesTheDateLine() {
    GeoPosition place = new GeoPosition(0, 179.9999, 0);
    AntennaState after =
        AntennaTrajectory.constantVelocity(place, BEGIN, 0, 10).at(BEGIN.plusSeconds(100));
    assertThat(after.position().longitude()).isBetween(-180.0, -179.99);
  }
}
