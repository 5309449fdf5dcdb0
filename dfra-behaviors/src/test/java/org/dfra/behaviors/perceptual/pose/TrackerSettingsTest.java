package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.behaviors.perceptual.pose.TrackerSettings.GpsErrors;
import org.dfra.behaviors.perceptual.pose.TrackerSettings.GyroErrors;
import org.junit.jupiter.api.Test;

class TrackerSettingsTest {

  @Test
  void refusesErrorsThatCannotBe() {
    assertThatThrownBy(() -> new GpsErrors(0, 1, 200, 0.05, 0.4, 0.16, 3))
        .hasMessage("gps_white_noise_sigma 0.0 is not finite and above 0; give such a number");
    assertThatThrownBy(() -> GpsErrors.DEFAULT.withBias(Double.POSITIVE_INFINITY))
        .hasMessage("gps_bias_sigma Infinity is not finite and at least 0; give such a number");
    assertThatThrownBy(() -> new GyroErrors(3e-4, Double.NaN, 2e-4, 0.01))
        .hasMessageContaining("gyro_bias_sigma NaN");
    assertThatThrownBy(() -> GpsErrors.DEFAULT.withBias(-1))
        .hasMessage("gps_bias_sigma -1.0 is not finite and at least 0; give such a number");
  }

  @Test
  void aCourseIsWorthMoreTheFasterButNeverAll() {
    assertThat(GpsErrors.DEFAULT.courseSigma(0.5)).isEqualTo(0.1);
    assertThat(GpsErrors.DEFAULT.courseSigma(100)).isEqualTo(0.03);
  }
}
