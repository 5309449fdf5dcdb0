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
}
