package org.dfra.examples.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleSupplier;
import org.dfra.examples.harness.CpuSpeed;
import org.dfra.examples.raster.RasterSetup.Mode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SimulationSpeedTest {

  private static final DoubleSupplier UNASKED =
      () -> {
        throw new AssertionError("the power was measured, though it does not count");
      };

  @Test
  void isWhatWasAskedForAndElseTheUsualOneInOneVirtualMachine() {
    SimulationSpeed asked = SimulationSpeed.of(7.5, Mode.PROCESSES, UNASKED);
    assertThat(asked.speed()).isEqualTo(7.5);
    assertThat(asked.slowdownReason()).isEmpty();
    for (Mode each : new Mode[] {Mode.EMBEDDED, Mode.LOCAL}) {
      assertThat(SimulationSpeed.of(null, each, UNASKED).speed()).isEqualTo(5);
    }
  }

  @ParameterizedTest
  @CsvSource({"4, 2.5", "1, 2.5", "0.9, 2.5", "0.89, 1.25", "0.6, 1.25", "0.59, 1", "0, 1"})
  void isSlowerInProcessesWhereTheComputerDoesNotKeepUp(double power, double speed) {
    SimulationSpeed pace = SimulationSpeed.of(null, Mode.PROCESSES, () -> power);
    assertThat(pace.speed()).isEqualTo(speed);
    assertThat(pace.slowdownReason().isPresent()).isEqualTo(speed < 2.5);
  }

  @Test
  void saysWhyItIsSlower() {
    assertThat(SimulationSpeed.of(null, Mode.PROCESSES, () -> 0.784).slowdownReason())
        .hasValue(
            "This computer now has 78 % of the speed that the simulation needs at 2.5 times real"
                + " time, so it runs at 1.25 times real time and takes longer. If other programs use the"
                + " computer, try again later, or set --speed.");
    assertThat(SimulationSpeed.of(null, Mode.PROCESSES, () -> 0.423).slowdownReason())
        .hasValueSatisfying(each -> assertThat(each).contains("so it runs in real time and takes"));
  }

  @Test
  void powerIsMeasuredNow() {
    assertThat(CpuSpeed.relativeToReference()).isBetween(0.01, 1000.0);
    Thread.currentThread().interrupt();
    assertThat(CpuSpeed.relativeToReference()).as("interrupted").isZero();
    assertThat(Thread.interrupted()).isTrue();
  }
}
