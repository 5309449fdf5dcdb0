package org.dfra.app.demo.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.DoubleSupplier;
import org.dfra.app.demo.harness.CpuSpeed;
import org.dfra.app.demo.raster.RasterSetup.Mode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PaceTest {

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
  @CsvSource({"4, 2.5", "1, 2.5", "0.6, 2.5", "0.59, 1.25", "0, 1.25"})
  void isSlowerInProcessesWhereTheComputerDoesNotKeepUp(double power, double speed) {
    SimulationSpeed pace = SimulationSpeed.of(null, Mode.PROCESSES, () -> power);
    assertThat(pace.speed()).isEqualTo(speed);
    assertThat(pace.slowdownReason().isPresent()).isEqualTo(speed < 2.5);
  }

  @Test
  void saysWhyItIsSlower() {
    assertThat(SimulationSpeed.of(null, Mode.PROCESSES, () -> 0.423).slowdownReason())
        .hasValue(
            "This computer can do 42 % now of what it takes to play it 2.5 times as fast as real"
                + " time; so it goes 1.25 times as fast, and takes twice as long. Where it is busy,"
                + " try again later, or with --speed.");
  }

  @Test
  void powerIsMeasuredNow() {
    assertThat(CpuSpeed.relativeToReference()).isBetween(0.01, 1000.0);
    Thread.currentThread().interrupt();
    assertThat(CpuSpeed.relativeToReference()).as("interrupted").isZero();
    assertThat(Thread.interrupted()).isTrue();
  }
}
