package org.dfra.cli.persona;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.Attributes;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;

class AbilitiesTest {

  /** A record that the program does not know. */
  record WinchLoadAttributes(double load, boolean locked, String cable) implements Attributes {}

  @Test
  void showsEachKindOfAttributesOnALineWithUnits() {
    assertThat(
            Abilities.of(
                List.of(
                    new ModuleAttributes(
                        "atrv1",
                        "gps",
                        "D",
                        "h",
                        "a",
                        "1",
                        Readiness.READY,
                        Instant.EPOCH,
                        null,
                        0),
                    new SensorAttributes(
                        "GpsFix", List.of("continuous"), 1 / 255.0, 1, 2.5, List.of("Open sky.")),
                    new ChainAttributes(List.of(), List.of("GpsFix")),
                    new PoseAttributes("f", "atrv1/base_link", 0.3, 0, 0.8, 0, 0, 1.5),
                    new LocationAttributes(27.98, -82.45, 14.25, Instant.EPOCH),
                    new GpsReceiverAttributes("M12+", null, null, null, 12, List.of("2D", "3D")),
                    new WinchLoadAttributes(3, true, "steel"))))
        .containsExactly(
            "chain: gives GpsFix",
            "gps receiver: model M12+, channels 12, fix modes 2D 3D",
            "location: was at 27.980000°, -82.450000°, 14.3 m on 1970-01-01T00:00:00Z",
            "pose: mounted on atrv1/base_link at x 0.300 m, y 0.000 m, z 0.800 m; roll 0.000, pitch"
                + " 0.000, yaw 1.500 rad",
            "sensor: reads GpsFix at 0.003922 to 1 Hz, modes continuous, draws 2.5 W; needs: Open"
                + " sky.",
            "winch load: load 3, locked yes, cable steel");
  }

  @Test
  void saysNothingWhereNothingIsKnown() {
    assertThat(
            Abilities.of(
                List.of(new GpsReceiverAttributes(null, null, null, null, null, List.of()))))
        .isEmpty();
  }
}
