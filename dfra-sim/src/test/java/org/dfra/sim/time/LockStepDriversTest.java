package org.dfra.sim.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleQuery;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.M12Device;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** A real driver on a {@code sim:} link. */
@Timeout(120)
class LockStepDriversTest {

  private static final GeoPosition PLACE = new GeoPosition(52.9, -6.9, 55.9);

  private final LockStep time = new LockStep(Instant.parse("2026-01-21T07:33:29Z"));
  private final SimPort port =
      new SimPort("gps", new M12Device(AntennaTrajectory.fixed(PLACE), 9600, Duration.ZERO), time);

  @Test
  void anHourOfADriverHasAFixForEverySecond() throws Exception {
    List<Instant> reported = new ArrayList<>();
    try (port;
        M12PlusImpl gps = new M12PlusImpl(context(port.url()))) {
      port.start();
      listen(gps, reported);
      gps.start();
      assertThat(gps.readiness()).isEqualTo(Readiness.INITIALIZING);
      time.advance(Duration.ofHours(1));
      assertThat(gps.readiness()).isEqualTo(Readiness.ACTIVE);
      assertThat(gps.history().failures()).isZero();
      assertThat(gps.counts().droppedBytes()).isZero();
      assertThat(reported).hasSizeBetween(3599, 3601).isSorted();
      assertThat(gps.fix().utc()).isBetween(time.instant().minusSeconds(2), time.instant());
    }
  }

  @Test
  void aPulledCableIsLostAndARestoredOneIsFound() {
    try (port;
        M12PlusImpl gps = new M12PlusImpl(context(port.url()))) {
      port.start();
      gps.start();
      assertThat(comesTo(gps, Readiness.READY)).isTrue();
      port.cable().unplug();
      assertThat(comesTo(gps, Readiness.INITIALIZING)).isTrue();
      assertThatThrownBy(gps::fix).hasMessageContaining("sim:gps: the device is lost");
      time.advance(Duration.ofMinutes(1));
      assertThatThrownBy(gps::fix)
          .hasMessageContaining("sim:gps: the cable of this simulated device is pulled out");
      port.cable().restore();
      assertThat(comesTo(gps, Readiness.READY)).isTrue();
      assertThat(gps.history().failures()).isEqualTo(1);
    }
  }

  @Test
  void anExaminationByTheStepperMovesTheTimeOn() {
    try (port;
        M12PlusImpl gps = new M12PlusImpl(context(port.url()))) {
      port.start();
      gps.start();
      assertThat(comesTo(gps, Readiness.READY)).isTrue();
      for (String test : List.of("link", "positions", "identification")) {
        Instant before = time.instant();
        Diagnosis diagnosis = gps.test(test);
        assertThat(diagnosis.passed()).as("%s", diagnosis).isTrue();
        assertThat(diagnosis.duration()).isEqualTo(Duration.between(before, time.instant()));
      }
      Diagnosis reopened = gps.recover("reopen_link");
      assertThat(reopened.passed()).as("%s", reopened).isTrue();
    }
  }

  @Test
  void awaitingAModuleAdvancesTheTime() throws InterruptedException {
    try (port;
        M12PlusImpl gps = new M12PlusImpl(context(port.url()));
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(time)) {
      ModuleQuery<GPSSensor> query = ModuleQuery.of(GPSSensor.class);
      assertThat(directory.findFirst(query, Duration.ofSeconds(1))).isEmpty();
      assertThat(time.nanos()).isEqualTo(1_000_000_000L);
      time.after(
          500_000_000L,
          () -> {
            var unused = directory.add(gps);
            gps.start();
          });
      assertThat(directory.findFirst(query, Duration.ofHours(1))).isPresent();
      assertThat(time.nanos()).isEqualTo(1_500_000_000L);
      assertThat(gps.awaitReadiness(Duration.ofSeconds(2))).isEqualTo(Readiness.INITIALIZING);
      assertThat(time.nanos()).isEqualTo(3_500_000_000L);
      port.start();
      assertThat(gps.awaitReadiness(Duration.ofHours(1))).isEqualTo(Readiness.READY);
      assertThat(time.instant()).isBefore(Instant.parse("2026-01-21T07:33:49Z"));
    }
  }

  private boolean comesTo(M12PlusImpl gps, Readiness expected) {
    return time.advanceUntil(() -> gps.readiness() == expected, Duration.ofSeconds(20));
  }

  private static void listen(M12PlusImpl gps, List<Instant> reported) {
    var unused =
        gps.subscribe(
            delivery -> {
              if (delivery.event() instanceof NewReading reading
                  && reading.reading() instanceof GpsFix) {
                reported.add(delivery.published());
              }
            },
            DeliveryPolicy.keepLast(1));
  }

  private ModuleContext context(String link) {
    return new ModuleContext(
        "atrv1", "gps", Parameters.of("atrv1/gps", Map.of("link", link)), time);
  }
}
