package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.ReceiverImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.module.Readiness;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * What every receiver's driver must do with its emulated receiver over TCP. Both live by a clock
 * that runs twenty times as fast.
 */
@Timeout(60)
abstract class ReceiverDriverContract {

  private static final GeoPosition PLACE = new GeoPosition(52.910313611, -6.866706667, 55.91);

  private final InstantSource clock = FastClock.of(20);
  private DeviceEmulator emulator;
  private Relay relay;

  /** A receiver on a line of 115 200 baud. */
  abstract SerialDevice device(AntennaPath path, Duration timeToFirstFix);

  abstract ReceiverImpl<?> driver(ModuleContext context);

  /** How far a told position may be from the true one, degrees: half of what the protocol tells. */
  abstract double resolution();

  /** The tests of the hardware, besides those of all receivers. */
  abstract List<String> furtherTests();

  @BeforeEach
  void start() throws IOException {
    emulator = emulated(AntennaPath.fixed(PLACE), Duration.ZERO);
    relay = new Relay(emulator.port());
  }

  @AfterEach
  void end() throws IOException {
    relay.close();
    emulator.close();
  }

  @Test
  void findsItsFirstFix() {
    try (ReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      GpsFix fix = gps.fix();
      assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      assertThat(fix.position().latitude()).isCloseTo(PLACE.latitude(), within(resolution()));
      assertThat(fix.position().longitude()).isCloseTo(PLACE.longitude(), within(resolution()));
      assertThat(fix.position().height()).isCloseTo(PLACE.height(), within(0.011));
      assertThat(fix.satellitesTracked()).isEqualTo(9);
      assertThat(gps.time().hostOffset()).isBetween(Duration.ZERO, Duration.ofSeconds(5));
      await().until(() -> gps.satellites().size() == 9);
      assertThat(gps.satellites().get(0).elevation()).isNotNull();
      assertThat(gps.counts().malformed()).isZero();
      assertThat(gps.counts().droppedBytes()).isZero();
    }
  }

  @Test
  void waitsForAReceiverThatSearches() throws IOException {
    try (DeviceEmulator cold = emulated(AntennaPath.fixed(PLACE), Duration.ofSeconds(20));
        ReceiverImpl<?> gps = started(cold.url())) {
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(gps::fix)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessageStartingWith(
                          "atrv1/gps is INITIALIZING: the receiver has no position"));
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @Test
  void comesBackWhenTheCableWasPulledAndPutBackAndCountsIt() {
    try (ReceiverImpl<?> gps = started(relay.url())) {
      awaitReadiness(gps, Readiness.READY);
      for (int pulled = 1; pulled <= 3; pulled++) {
        relay.cut();
        awaitReadiness(gps, Readiness.INITIALIZING);
        assertThatThrownBy(gps::fix).isInstanceOf(NotReadyException.class);
        relay.restore();
        awaitReadiness(gps, Readiness.READY);
        assertThat(gps.history().failures()).isEqualTo(pulled);
      }
      assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
    }
  }

  @Test
  void noticesASilentReceiverAndItsReturn() {
    try (ReceiverImpl<?> gps = started(relay.url())) {
      awaitReadiness(gps, Readiness.READY);
      relay.silence(true);
      awaitReadiness(gps, Readiness.INITIALIZING);
      relay.silence(false);
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @Test
  void readsOnThroughAStormOfGarbage() {
    long seed = new Random().nextLong();
    relay.garbage(new Random(seed));
    try (ReceiverImpl<?> gps = started(relay.url())) {
      awaitReadiness(gps, Readiness.READY);
      await("seed " + seed).until(() -> gps.counts().droppedBytes() > 10_000);
      relay.garbage(null);
      awaitReadiness(gps, Readiness.READY);
      assertThat(gps.fix().position().height()).isCloseTo(PLACE.height(), within(0.011));
    }
  }

  @Test
  void tellsEveryFixOfAReceiverThatDrifts() throws Exception {
    AntennaPath path = AntennaPath.drifting(PLACE, clock.instant(), 0.6, -0.8);
    List<GpsFix> fixes = new CopyOnWriteArrayList<>();
    try (DeviceEmulator boat = emulated(path, Duration.ZERO);
        ReceiverImpl<?> gps = started(boat.url())) {
      try (Subscription unused =
          gps.subscribe(
              delivery -> {
                if (delivery.event() instanceof NewReading reading
                    && reading.reading() instanceof GpsFix fix) {
                  fixes.add(fix);
                }
              },
              DeliveryPolicy.keepLast(100))) {
        await().until(() -> fixes.size() >= 5);
      }
      for (int i = 1; i < 5; i++) {
        assertThat(fixes.get(i).position().latitude())
            .isGreaterThan(fixes.get(i - 1).position().latitude());
        assertThat(fixes.get(i).utc()).isAfter(fixes.get(i - 1).utc());
        assertThat(fixes.get(i).speed()).isCloseTo(1, within(0.001));
        assertThat(fixes.get(i).course()).isCloseTo(306.87, within(0.05));
      }
    }
  }

  @Test
  void passesItsTestsWhenAllIsWell() {
    try (ReceiverImpl<?> gps = started(relay.url())) {
      awaitReadiness(gps, Readiness.READY);
      await().until(() -> gps.satellites().size() == 9);
      assertThat(gps.tests()).startsWith("link", "positions", "satellites");
      assertThat(gps.tests().subList(3, gps.tests().size())).isEqualTo(furtherTests());
      for (String test : gps.tests()) {
        Diagnosis diagnosis = gps.test(test);
        assertThat(diagnosis.passed()).as("%s", diagnosis).isTrue();
      }
      assertThat(gps.preconditions()).isNotEmpty();
      Diagnosis reopened = gps.recover("reopen_link");
      assertThat(reopened.passed()).as("%s", reopened).isTrue();
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @Test
  void describesItself() {
    try (ReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      assertThat(gps.attributes())
          .hasAtLeastOneElementOfType(GpsReceiverAttributes.class)
          .hasAtLeastOneElementOfType(SensorAttributes.class)
          .hasAtLeastOneElementOfType(LocationAttributes.class);
    }
  }

  private DeviceEmulator emulated(AntennaPath path, Duration timeToFirstFix) throws IOException {
    DeviceEmulator made = new DeviceEmulator("gps", 0, device(path, timeToFirstFix), clock);
    made.start();
    return made;
  }

  private ReceiverImpl<?> started(String link) {
    Map<String, String> parameters = Map.of("link", link);
    ReceiverImpl<?> gps =
        driver(new ModuleContext("atrv1", "gps", Parameters.of("atrv1/gps", parameters), clock));
    gps.start();
    return gps;
  }

  private static void awaitReadiness(ReceiverImpl<?> gps, Readiness expected) {
    await()
        .atMost(Duration.ofSeconds(20))
        .pollInterval(Duration.ofMillis(5))
        .until(gps::readiness, expected::equals);
  }
}
