package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleQuery;
import org.dfra.drivers.laser.lms.LmsAttributes;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.RangeAttributes;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.sensor.RangeProxy;
import org.dfra.river.server.sensor.RangeServer;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;
import org.dfra.sim.physics.RangeInput;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A laser is found by what it can see, and read near and far. */
class LaserTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  /** A wall to the right, 3 m away, and nothing to the left. */
  private static final RangeInput WALL =
      (time, first, step, longest, distances) -> {
        for (int i = 0; i < distances.length; i++) {
          double angle = first + i * step;
          distances[i] = angle < -0.1 ? 3 / Math.sin(-angle) : Double.POSITIVE_INFINITY;
        }
      };

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @Test
  void isFoundByWhatItSeesAndServesThroughServerAndProxyOfItsKind() throws Exception {
    LmsDevice device = new LmsDevice(WALL, LmsEmulatorSettings.factoryDefault());
    try (DeviceEmulator emulator = new DeviceEmulator("laser", 0, device, Instant::now)) {
      emulator.start();
      ServedModule<RangeServer> laser =
          ServedModule.of(RangeServer.class, RangeProxy.class, LmsImpl.class)
              .with("link", emulator.url())
              .with("baud", "500000")
              .with("units", "cm")
              .joining(REGGIE);
      ModuleQuery<RangeSensor> query =
          ModuleQuery.of(RangeSensor.class)
              .where(RangeAttributes.class, "maxRange", Condition.atLeast(50))
              .where(RangeAttributes.class, "fieldOfView", Condition.atLeast(3))
              .where(LmsAttributes.class, "type", Condition.equalTo("LMS200;30106;V02.30"))
              .where(ModuleAttributes.class, "state", Condition.equalTo(Readiness.READY));
      try (RangeServer server = laser.serve();
          JiniModuleDirectory directory = REGGIE.directory()) {
        RangeProxy found = (RangeProxy) directory.findFirst(query, PATIENCE).orElseThrow().module();
        RangeProxy elsewhere =
            new RangeProxy(found.server(), UUID.randomUUID(), found.identification()); // by network
        assertWall(found.scan());
        assertWall(elsewhere.scan());
        assertThat(elsewhere.test("status").passed()).as("%s", server).isTrue();
        List<RangeScan> scans = new CopyOnWriteArrayList<>();
        try (Subscription unused =
            elsewhere.subscribe(
                delivery -> {
                  if (delivery.event() instanceof NewReading reading
                      && reading.reading() instanceof RangeScan scan) {
                    scans.add(scan);
                  }
                },
                DeliveryPolicy.keepLast(10))) {
          await().atMost(PATIENCE).until(() -> scans.size() >= 5);
        }
        assertWall(scans.get(4));
      }
    }
  }

  private static void assertWall(RangeScan scan) {
    assertThat(scan.beams()).isEqualTo(361);
    assertThat((double) scan.range(0)).as("right").isCloseTo(3, within(0.0051)); // half a cm
    assertThat((double) scan.range(60)).isCloseTo(3 / Math.sin(-scan.angle(60)), within(0.0051));
    assertThat(scan.range(360)).as("left").isEqualTo(Float.POSITIVE_INFINITY);
  }
}
