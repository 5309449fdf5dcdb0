package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitReadiness;

import java.io.IOException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.TimeReading;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.gps.M12EmulatorSettings.M12EmulatorOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The real driver and the emulated receiver over TCP. Driver and receiver live by a clock that runs
 * twenty times as fast, so that waits of seconds take no seconds.
 */
@Timeout(180)
class M12DriverTest {

  private static final GeoPosition PLACE = new GeoPosition(52.910313611, 6.866706667, 55.91);

  private final InstantSource clock = FastClock.of(5);
  private M12Emulator emulator;

  @BeforeEach
  void start() throws IOException {
    emulator = new M12Emulator(M12EmulatorSettings.at(PLACE).withBaud(115_200), clock);
    emulator.start();
  }

  @AfterEach
  void end() {
    emulator.close();
  }

  @Test
  void findsItsFirstFix() {
    Instant begin = clock.instant().minusSeconds(2); // it reports the full second before
    try (M12PlusImpl gps = driver(emulator.url(), Map.of())) {
      gps.start();
      awaitReadiness(gps, Readiness.READY);
      GpsFix fix = await().until(gps::fix, Objects::nonNull);
      assertThat(fix.mode()).isEqualTo(GpsFix.Mode.FIX_3D);
      // half a milli-arc-second, what the receiver can tell
      assertThat(gps.location().position().latitude()).isCloseTo(PLACE.latitude(), within(1.4e-7));
      assertThat(gps.location().position().longitude())
          .isCloseTo(PLACE.longitude(), within(1.4e-7));
      assertThat(gps.location().position().height()).isEqualTo(55.91);
      assertThat(fix.satellitesTracked()).isEqualTo(9);
      // both live by the same clock
      assertThat(gps.time().utc()).isBetween(begin, clock.instant());
      assertThat(gps.time().hostOffset()).isGreaterThanOrEqualTo(Duration.ZERO);
      await().until(() -> gps.identified().isPresent());
      assertThat(gps.identified().orElseThrow().model()).isEqualTo("P283T12T11");
      assertThat(gps.counts().malformed()).isZero();
    }
  }

  @Test
  void atItsOwnSpeedAndInRealTimeToo() throws IOException {
    try (M12Emulator real = new M12Emulator(M12EmulatorSettings.at(PLACE), Clock.systemUTC())) {
      real.start();
      ModuleContext context =
          new ModuleContext(
              "atrv1",
              "gps_front",
              Parameters.of("atrv1/gps_front", Map.of("link", real.url())),
              Clock.systemUTC());
      try (M12PlusImpl gps = new M12PlusImpl(context)) {
        gps.start();
        assertThat(gps.awaitReadiness(Duration.ofSeconds(60))).isEqualTo(Readiness.READY);
        // 294 + 8 + 154 bytes at 960 bytes/s are 0.475 s
        assertThat(gps.time().hostOffset()).isGreaterThan(Duration.ofMillis(400));
      }
    }
  }

  @Test
  void waitsForAReceiverThatSearches() throws IOException {
    M12EmulatorSettings cold =
        M12EmulatorSettings.at(PLACE).withBaud(115_200).withTimeToFirstFix(Duration.ofSeconds(20));
    try (M12Emulator searching = new M12Emulator(cold, clock);
        M12PlusImpl gps = started(searching)) {
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(gps::fix)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessage(
                          "atrv1/gps_front is INITIALIZING: the receiver has no position yet, it is"
                              + " acquiring satellites, 2 of 11 tracked"));
      awaitReadiness(gps, Readiness.READY);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 12})
  void doesNotTakeGpsTimeForUtcBeforeTheReceiverHasLearnedTheDifference(int channels)
      throws IOException {
    M12EmulatorSettings withoutAlmanac =
        M12EmulatorSettings.at(PLACE)
            .withBaud(115_200)
            .withOptions(new M12EmulatorOptions(channels, Duration.ofSeconds(60)));
    try (M12Emulator fresh = new M12Emulator(withoutAlmanac, clock);
        M12PlusImpl gps = started(fresh)) {
      awaitReadiness(gps, Readiness.READY);
      GpsFix early = gps.fix();
      assertThat(early.utc())
          .as("it reports GPS time, 18 s ahead; the computer's clock is taken")
          .isBeforeOrEqualTo(clock.instant());
      assertThatThrownBy(gps::time)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("has not yet learned from the satellites how far GPS time is");
      TimeReading time =
          await().ignoreException(NotReadyException.class).until(gps::time, t -> true);
      assertThat(time.utc()).isBeforeOrEqualTo(clock.instant());
      assertThat(time.hostOffset()).isBetween(Duration.ZERO, Duration.ofSeconds(17));
    }
  }

  @Test
  void comesBackWhenTheReceiverWasReplaced() throws IOException {
    int port = emulator.port();
    try (M12PlusImpl gps = driver(emulator.url(), Map.of())) {
      gps.start();
      awaitReadiness(gps, Readiness.READY);
      emulator.close();
      awaitReadiness(gps, Readiness.INITIALIZING);
      GeoPosition elsewhere = new GeoPosition(-10, 20, 300);
      M12EmulatorSettings settings =
          M12EmulatorSettings.at(elsewhere).withPort(port).withBaud(115_200);
      try (M12Emulator next = new M12Emulator(settings, clock)) {
        next.start();
        awaitReadiness(gps, Readiness.READY);
        assertThat(gps.location().position()).isEqualTo(elsewhere);
      }
    }
  }

  @Test
  void closesWhileItWaitsToTryAgain() {
    emulator.cable().unplug();
    try (M12PlusImpl gps =
        driver(
            emulator.url(), Map.of("reopen_initial_delay", "3600", "reopen_max_delay", "3600"))) {
      gps.start();
      awaitReadiness(gps, Readiness.INITIALIZING);
    }
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().equals("gps_front reader"));
  }

  private M12PlusImpl started(M12Emulator receiver) throws IOException {
    receiver.start();
    M12PlusImpl gps = driver(receiver.url(), Map.of());
    gps.start();
    return gps;
  }

  private M12PlusImpl driver(String link, Map<String, String> more) {
    Map<String, String> parameters = new HashMap<>(more);
    parameters.put("link", link);
    return new M12PlusImpl(
        new ModuleContext(
            "atrv1", "gps_front", Parameters.of("atrv1/gps_front", parameters), clock));
  }
}
