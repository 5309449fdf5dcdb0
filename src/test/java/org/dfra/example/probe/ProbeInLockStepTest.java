package org.dfra.example.probe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.time.LockStep;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver and the emulated probe in lock-step: hours take no time, and are always the same. */
@Timeout(60)
class ProbeInLockStepTest {

  private final LockStep time = new LockStep(Instant.parse("2026-06-01T12:00:00Z"));
  private final SimPort probe = new SimPort("probe", new ProbeDevice(21.5), time);

  @Test
  void isMissedForAnHourAndServesAgain() {
    probe.start();
    Parameters parameters = Parameters.of("robot/probe", Map.of("link", probe.url()));
    ModuleContext context = new ModuleContext("robot", "probe", parameters, time);
    try (ProbeThermometerImpl thermometer = new ProbeThermometerImpl(context)) {
      thermometer.start();
      assertThat(thermometer.awaitReadiness(Duration.ofSeconds(5))).isEqualTo(Readiness.READY);
      probe.cable().unplug();
      time.advance(Duration.ofHours(1));
      assertThatThrownBy(thermometer::celsius)
          .isInstanceOf(NotReadyException.class)
          .hasMessageEndingWith("sim:probe: the cable of this simulated device is pulled out");
      probe.cable().restore();
      assertThat(thermometer.awaitReadiness(Duration.ofSeconds(20))).isEqualTo(Readiness.READY);
      assertThat(thermometer.celsius()).isEqualTo(21.5);
      assertThat(thermometer.history().failures()).isEqualTo(1);
    }
  }
}
