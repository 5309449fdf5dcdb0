package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitReadiness;
import static org.dfra.sim.device.Modules.awaitRecovered;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.SerialDevice;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * What every receiver's driver must do with its emulated receiver over TCP. Both use a clock that
 * runs five times as fast: a computer that stops for a second is a receiver that is silent.
 */
@Timeout(180)
abstract class ReceiverDriverContract {

  private static final GeoPosition PLACE = new GeoPosition(52.910313611, -6.866706667, 55.91);

  private final InstantSource clock = FastClock.of(5);
  private DeviceEmulator emulator;

  /** A receiver on a line of 115 200 baud. */
  abstract SerialDevice device(AntennaTrajectory path, Duration timeToFirstFix);

  abstract GpsReceiverImpl<?> driver(ModuleContext context);

  /** How far a reported position may be off, degrees: half of the resolution of the protocol. */
  abstract double resolution();

  /** The tests of the hardware, besides those of all receivers. */
  abstract List<String> furtherTests();

  @BeforeEach
  void start() throws IOException {
    emulator = emulated(AntennaTrajectory.fixed(PLACE), Duration.ZERO);
  }

  @AfterEach
  void end() {
    emulator.close();
  }

  @Test
  void findsItsFirstFix() {
    Instant begin = clock.instant().minusSeconds(2); // it reports the full second before
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      GpsFix fix = awaitWholeFix(gps);
      long dropped = gps.counts().droppedBytes();
      assertThat(fix.position().latitude()).isCloseTo(PLACE.latitude(), within(resolution()));
      assertThat(fix.position().longitude()).isCloseTo(PLACE.longitude(), within(resolution()));
      assertThat(fix.position().height()).isCloseTo(PLACE.height(), within(0.011));
      assertThat(fix.satellitesTracked()).isEqualTo(9);
      TimeReading time = await().until(gps::time, Objects::nonNull);
      assertThat(time.utc()).isBetween(begin, clock.instant());
      assertThat(time.hostOffset()).isGreaterThanOrEqualTo(Duration.ZERO);
      await().until(() -> gps.satellites().size() == 9);
      assertThat(gps.satellites().get(0).elevation()).isNotNull();
      assertThat(gps.counts().malformed()).isZero();
      // Where it was opened in the middle of a sentence, the rest of it was dropped.
      if (gps.history().failures() == 0) {
        assertThat(gps.counts().droppedBytes()).isEqualTo(dropped);
      }
    }
  }

  @Test
  void waitsForAReceiverThatSearches() throws IOException {
    try (DeviceEmulator cold = emulated(AntennaTrajectory.fixed(PLACE), Duration.ofSeconds(20));
        GpsReceiverImpl<?> gps = started(cold.url())) {
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
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      for (int pulled = 1; pulled <= 3; pulled++) {
        emulator.cable().unplug();
        awaitReadiness(gps, Readiness.INITIALIZING);
        assertThatThrownBy(gps::fix).isInstanceOf(NotReadyException.class);
        emulator.cable().restore();
        awaitReadiness(gps, Readiness.READY);
        assertThat(gps.history().failures()).isGreaterThanOrEqualTo(pulled);
      }
      GpsFix unused = awaitWholeFix(gps);
    }
  }

  @Test
  void noticesASilentReceiverAndItsReturn() {
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      emulator.cable().mute();
      awaitReadiness(gps, Readiness.INITIALIZING);
      emulator.cable().restore();
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @Test
  void readsOnOverABadContact() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      emulator.cable().corruptBytes(seed, 0.002); // most frames have a byte or two that are damaged
      await("-Ddfra.seed=" + seed).until(() -> gps.counts().droppedBytes() > 1_000);
      emulator.cable().restore();
      // The last fix of the bad contact may lack its height: its sentence was damaged.
      await("-Ddfra.seed=" + seed)
          .untilAsserted(
              () -> {
                assertThat(gps.fix().mode()).isEqualTo(GpsFix.Mode.FIX_3D);
                assertThat(gps.fix().position().height()).isCloseTo(PLACE.height(), within(0.011));
              });
    }
  }

  @Test
  void reportsEveryFixOfAReceiverThatDrifts() throws Exception {
    AntennaTrajectory path = AntennaTrajectory.constantVelocity(PLACE, clock.instant(), 0.6, -0.8);
    List<GpsFix> fixes = new CopyOnWriteArrayList<>();
    try (DeviceEmulator boat = emulated(path, Duration.ZERO);
        GpsReceiverImpl<?> gps = started(boat.url())) {
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
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      await().until(() -> gps.satellites().size() == 9);
      assertThat(gps.tests()).startsWith("link", "positions", "satellites");
      assertThat(gps.tests().subList(3, gps.tests().size())).isEqualTo(furtherTests());
      awaitPassed(gps);
      assertThat(gps.preconditions()).isNotEmpty();
      awaitRecovered(gps, "reopen_link");
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @Test
  void describesItself() {
    try (GpsReceiverImpl<?> gps = started(emulator.url())) {
      awaitReadiness(gps, Readiness.READY);
      assertThat(gps.attributes())
          .hasAtLeastOneElementOfType(GpsReceiverAttributes.class)
          .hasAtLeastOneElementOfType(SensorAttributes.class)
          .hasAtLeastOneElementOfType(LocationAttributes.class);
    }
  }

  /**
   * The first one may lack its height, where the link was opened amid the sentences of a moment.
   */
  private static GpsFix awaitWholeFix(GpsReceiverImpl<?> gps) {
    return await().until(gps::fix, fix -> fix.mode() == GpsFix.Mode.FIX_3D);
  }

  private DeviceEmulator emulated(AntennaTrajectory path, Duration timeToFirstFix)
      throws IOException {
    DeviceEmulator made = new DeviceEmulator("gps", 0, device(path, timeToFirstFix), clock);
    made.start();
    return made;
  }

  private GpsReceiverImpl<?> started(String link) {
    Map<String, String> parameters = Map.of("link", link);
    GpsReceiverImpl<?> gps =
        driver(new ModuleContext("atrv1", "gps", Parameters.of("atrv1/gps", parameters), clock));
    gps.start();
    return gps;
  }
}
