package org.dfra.sim.world.description;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dfra.core.config.ConfigurationException;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.junit.jupiter.api.Test;

class DeviceDescriptionTest {

  private static final DeviceDescription GPS =
      new DeviceDescription(DeviceKind.GPS, "gps_front", MountPose.MIDDLE);

  @Test
  void aParameterOfItsKindCanBeChanged() {
    assertThat(GPS.with("bias_sigma", 0.2).parameter("bias_sigma", VehicleType.UGV)).isEqualTo(0.2);
    assertThat(GPS.parameter("bias_sigma", VehicleType.UGV)).isEqualTo(1.5);
  }

  /** It would have no effect: the simulation reads the kind's parameters only. */
  @Test
  void aParameterThatItsKindDoesNotHaveIsRefused() {
    assertThatThrownBy(() -> GPS.with("bias", 0.2))
        .isInstanceOf(ConfigurationException.class)
        .hasMessageContaining("gps has no parameter bias");
  }
}
