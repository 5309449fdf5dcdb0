package org.dfra.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class GeoPositionTest {

  @Test
  void takesTheWholeEarth() {
    assertThat(new GeoPosition(-90, 180, -430).latitude()).isEqualTo(-90);
    assertThat(new GeoPosition(90, -180, 8849).height()).isEqualTo(8849);
  }

  @Test
  void refusesWhatIsOffIt() {
    assertThatThrownBy(() -> new GeoPosition(90.1, 0, 0))
        .hasMessage("latitude 90.1° is outside −90° to 90°");
    assertThatThrownBy(() -> new GeoPosition(Double.NaN, 0, 0)).hasMessageStartingWith("latitude");
    assertThatThrownBy(() -> new GeoPosition(0, -180.1, 0))
        .hasMessage("longitude -180.1° is outside −180° to 180°");
    assertThatThrownBy(() -> new GeoPosition(0, Double.NaN, 0)).hasMessageStartingWith("longitude");
    assertThatThrownBy(() -> new GeoPosition(0, 0, Double.POSITIVE_INFINITY))
        .hasMessage("height Infinity m is not a finite number");
  }

  @Test
  void groundDistanceIsTheChordOnTheEllipsoid() {
    GeoPosition pole = new GeoPosition(90, 0, 0);
    // Twice the semi-minor axis of WGS84, to the millimetre that it is published to.
    assertThat(pole.groundDistance(new GeoPosition(-90, 17, 5_000)))
        .isCloseTo(2 * 6_356_752.314, org.assertj.core.api.Assertions.within(0.002));
    // A second of arc along the equator: a × π / 648000; the chord differs by 1e-9 m.
    assertThat(new GeoPosition(0, 0, 0).groundDistance(new GeoPosition(0, 1 / 3600.0, 9)))
        .isCloseTo(6_378_137 * Math.PI / 648_000, org.assertj.core.api.Assertions.within(1e-6));
  }
}
