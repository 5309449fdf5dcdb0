package org.dfra.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** {@link GeodesyTest} and {@link LocalFrameTest} check both directions of the conversion. */
class Wgs84Test {

  /** The radii of curvature at the equator and at the pole are published, to the millimetre. */
  @Test
  void radiiAreThoseOfTheReport() {
    assertThat(Wgs84.primeVerticalRadius(0)).isEqualTo(Wgs84.EQUATORIAL_RADIUS);
    assertThat(Wgs84.meridianRadius(0)).isCloseTo(6_335_439.327, within(5e-4));
    assertThat(Wgs84.primeVerticalRadius(-90)).isCloseTo(6_399_593.626, within(5e-4));
    assertThat(Wgs84.meridianRadius(90)).isCloseTo(6_399_593.626, within(5e-4));
  }
}
