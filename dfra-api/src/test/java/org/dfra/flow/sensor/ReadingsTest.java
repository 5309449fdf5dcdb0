package org.dfra.flow.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import org.dfra.flow.sensor.GpsFix.Mode;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class ReadingsTest {

  private static final GeoPosition POSITION = new GeoPosition(52.9, 6.9, 56);

  private static GpsFix fix(
      Mode mode, @Nullable GeoPosition position, double speed, double course) {
    return new GpsFix(mode, position, Instant.EPOCH, speed, course, 1.5, 9, 8);
  }

  @Test
  void aFixHasAPositionExactlyWhereItsModeSaysSo() {
    assertThat(fix(Mode.FIX_3D, POSITION, 0, 0).height()).hasValue(56);
    assertThat(fix(Mode.NONE, null, 0, 0).height()).isEmpty();
    assertThatThrownBy(() -> fix(Mode.FIX_2D, null, 0, 0))
        .hasMessage("a fix of mode FIX_2D without a position");
    assertThatThrownBy(() -> fix(Mode.NONE, POSITION, 0, 0))
        .hasMessage("a fix of mode NONE with a position");
  }

  @Test
  void aFixChecksSpeedAndCourse() {
    assertThat(fix(Mode.NONE, null, 0, 360).course()).isEqualTo(360);
    assertThatThrownBy(() -> fix(Mode.NONE, null, -0.1, 0)).hasMessage("speed -0.1 m/s is not ≥ 0");
    assertThatThrownBy(() -> fix(Mode.NONE, null, 0, 360.1))
        .hasMessage("course 360.1° is outside 0° to 360°");
    assertThatThrownBy(() -> fix(Mode.NONE, null, 0, -0.1))
        .hasMessage("course -0.1° is outside 0° to 360°");
  }

  @Test
  void aFixOfAReceiverThatReportsNoMotionHasUnknownSpeedAndCourse() {
    GpsFix fix = fix(Mode.FIX_3D, POSITION, Double.NaN, Double.NaN);
    assertThat(fix.speed()).isNaN();
    assertThat(fix.course()).isNaN();
  }

  @Test
  void aLocationNamesItsFrame() {
    assertThatThrownBy(() -> new LocationReading(POSITION, " ", Instant.EPOCH))
        .hasMessage("a location reading names no frame");
  }

  @Test
  void aClockAheadOfTheSensorsTimeHasAPositiveOffset() {
    Instant reported = Instant.EPOCH;

    assertThat(new TimeReading(reported, reported.plusMillis(160)).hostOffset())
        .isEqualTo(Duration.ofMillis(160));
  }
}
