package org.dfra.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class TransformTest {

  @Test
  void givesBackTheAnglesItWasMadeOf() {
    Transform transform = Transform.of(1, 2, 3, 0.3, -0.4, 2.5);
    assertThat(transform.roll()).isCloseTo(0.3, within(1e-12));
    assertThat(transform.pitch()).isCloseTo(-0.4, within(1e-12));
    assertThat(transform.yaw()).isCloseTo(2.5, within(1e-12));
  }

  @Test
  void refusesAQuaternionThatTurnsNothing() {
    assertThatThrownBy(() -> new Transform(0, 0, 0, 1, 1, 0, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("the quaternion (1.0, 1.0, 0.0, 0.0) has length 1.41")
        .hasMessageEndingWith("scale it to 1");
    assertThatThrownBy(() -> Transform.translation(Double.NaN, 0, 0))
        .hasMessageContaining("not finite");
  }
}
