package org.dfra.sim.device.laser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitReadiness;
import static org.dfra.sim.device.Modules.failuresButSilence;
import static org.dfra.sim.device.Modules.number;
import static org.dfra.sim.device.Modules.parameter;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.drivers.laser.lms.LmsAttributes;
import org.dfra.drivers.laser.lms.LmsImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.RangeAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.NmeaDevice;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The real driver and the emulated laser over TCP, without faults and with them. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class LmsDriverTest {

  private final InstantSource clock = FastClock.of(Laser.SPEED);
  private LmsEmulatorSettings makeup;

  @BeforeEach
  void usual() {
    makeup = LmsEmulatorSettings.factoryDefault().withBaud(38_400);
  }

  @Test
  void seesWhatThereIs() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      RangeScan scan = Laser.scan(driver);
      assertThat(scan.beams()).isEqualTo(361);
      assertThat(scan.frame()).isEqualTo("atrv1/laser");
      assertThat(scan.angle(0)).isEqualTo(-Math.PI / 2);
      assertThat(scan.angle(360)).isCloseTo(Math.PI / 2, within(1e-9));
      assertThat(scan.measured()).isBefore(clock.instant());
      assertThat(scan.maxRange()).isCloseTo(8.182, within(1e-9));
      for (int beam = 0; beam < 361; beam++) {
        if (scan.angle(beam) > 1.5) {
          assertThat(scan.range(beam)).as("beam %d", beam).isEqualTo(Float.POSITIVE_INFINITY);
        } else { // half of what the laser counts in
          assertThat((double) scan.range(beam))
              .as("beam %d", beam)
              .isCloseTo(Laser.distance(scan.angle(beam)), within(0.000501));
        }
      }
      if (driver.history().failures() == 0) { // else it was opened again, amid a telegram
        assertThat(parameter(driver, "dropped_bytes")).isEqualTo("0");
      }
      assertThat(parameter(driver, "malformed_frames")).isEqualTo("0");
    }
  }

  @Test
  void writesTheFlashOnlyWhereItDiffers() throws IOException {
    try (Laser laser = new Laser(makeup, clock)) {
      try (LmsImpl first = laser.driver()) {
        awaitReadiness(first, Readiness.READY);
        assertThat(laser.device().flashWrites()).isEqualTo(1);
        assertThat(parameter(first, "flash_writes")).isEqualTo("1");
        first.recover("reopen_link");
        awaitReadiness(first, Readiness.READY);
      }
      try (LmsImpl second = laser.driver()) {
        awaitReadiness(second, Readiness.READY);
        assertThat(Laser.scan(second).maxRange()).isCloseTo(8.182, within(1e-9));
      }
      assertThat(laser.device().flashWrites()).as("it was right already").isEqualTo(1);
      try (LmsImpl third = laser.driver("units", "keep", "measuring_mode", "6")) {
        awaitReadiness(third, Readiness.READY);
        assertThat(Laser.scan(third).maxRange()).isCloseTo(32.758, within(1e-9));
        assertThat(laser.device().flashWrites()).isEqualTo(2);
      }
    }
  }

  @Test
  void takesALaserThatRefusesAsItIs() throws IOException {
    try (Laser laser = new Laser(makeup.withLockedConfiguration(), clock);
        LmsImpl driver = laser.driver("resolution", "1")) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(laser.device().flashWrites()).isZero();
      RangeScan scan = Laser.scan(driver);
      assertThat(scan.maxRange()).as("centimetres, 13 bits").isEqualTo(80);
      assertThat(scan.beams()).isEqualTo(361);
      assertThat(driver.attributes())
          .contains(new RangeAttributes(0, 80, Math.PI, Math.toRadians(0.5), 0.01));
    }
  }

  @Test
  void changesItsBeamsWhileItRuns() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      driver.setParameter("resolution", "1");
      await().until(() -> beams(driver) == 181);
      driver.setParameter("field_of_view", "100");
      await().until(() -> beams(driver) == 101);
      driver.setParameter("resolution", "0.25");
      await().until(() -> beams(driver) == 401);
      RangeScan scan = Laser.scan(driver);
      assertThat((double) scan.range(0)).isCloseTo(Laser.distance(scan.angle(0)), within(0.0006));
      assertThatThrownBy(() -> driver.setParameter("field_of_view", "180"))
          .isInstanceOf(IllegalArgumentException.class);
      awaitReadiness(driver, Readiness.READY);
    }
  }

  @Test
  void asksForEveryScanWherePolled() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver("mode", "polled", "period", "0.5")) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(driver.updateRate()).isEqualTo(2);
      List<RangeScan> scans = new CopyOnWriteArrayList<>();
      try (Subscription unused = listen(driver, scans)) {
        await().until(() -> scans.size() >= 4);
      }
      for (int i = 1; i < scans.size(); i++) {
        assertThat(scans.get(i).measured()).isAfter(scans.get(i - 1).measured());
      }
      driver.setParameter("mode", "continuous");
      int before = scans.size();
      try (Subscription unused = listen(driver, scans)) {
        await().until(() -> scans.size() >= before + 3);
      }
    }
  }

  @Test
  void restsWithoutClientsAndWakesForTheFirst() throws Exception {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver("idle_timeout", "3")) {
      awaitReadiness(driver, Readiness.READY);
      await("rest is no failure")
          .until(
              () -> {
                await().until(() -> !laser.device().isStreaming());
                Instant scanned = clock.instant();
                long failures = driver.history().failures();
                await().until(() -> clock.instant().isAfter(scanned.plusSeconds(2)));
                return driver.history().failures() == failures
                    && driver.readiness() == Readiness.READY;
              });
      assertThatThrownBy(driver::scan)
          .isInstanceOf(NotReadyException.class)
          .hasMessageContaining("it is idle, since no client used it for 3.0 s; it starts now");
      await().until(() -> beams(driver) == 361);
      List<RangeScan> scans = new CopyOnWriteArrayList<>();
      try (Subscription unused = listen(driver, scans)) {
        await().until(() -> scans.size() >= 20); // longer than idle_timeout
        awaitReadiness(driver, Readiness.ACTIVE);
      }
      assertThat(failuresButSilence(driver)).isEmpty();
    }
  }

  @Test
  void comesBackWhenTheCableWasPulledAndPutBack() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      laser.cable().unplug();
      awaitReadiness(driver, Readiness.INITIALIZING);
      assertThatThrownBy(driver::scan).isInstanceOf(NotReadyException.class);
      laser.cable().restore();
      awaitReadiness(driver, Readiness.READY);
      assertThat(driver.history().failures()).isPositive();
    }
  }

  @Test
  void noticesASilentLaserAndItsReturn() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver("idle_timeout", "0")) {
      awaitReadiness(driver, Readiness.READY);
      laser.cable().mute();
      awaitReadiness(driver, Readiness.INITIALIZING);
      laser.cable().restore();
      awaitReadiness(driver, Readiness.READY);
    }
  }

  @Test
  void readsOnThroughAStormOfGarbage() throws IOException {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    try (Laser laser = new Laser(makeup, clock)) {
      laser.cable().injectNoiseBursts(seed);
      try (LmsImpl driver = laser.driver("idle_timeout", "0")) {
        await("-Ddfra.seed=" + seed).until(() -> number(driver, "dropped_bytes") > 20_000);
        laser.cable().restore();
        await("-Ddfra.seed=" + seed).until(driver::readiness, Readiness.READY::equals);
        await("-Ddfra.seed=" + seed).until(() -> beams(driver) == 361);
      }
    }
  }

  @Test
  void configuresALaserAgainThatWasSwitchedOffAndOn() throws IOException {
    Laser laser = new Laser(makeup, clock);
    int port = laser.emulator().port();
    try (LmsImpl driver = Laser.driverAt(laser.emulator().url(), clock, "resolution", "1")) {
      driver.start();
      awaitReadiness(driver, Readiness.READY);
      laser.close();
      awaitReadiness(driver, Readiness.INITIALIZING);
      try (Laser next = new Laser(makeup.withWarmUp(Duration.ofSeconds(5)), clock, port)) {
        awaitReadiness(driver, Readiness.READY);
        assertThat(Laser.scan(driver).beams()).isEqualTo(181);
        assertThat(next.device().flashWrites()).isEqualTo(1);
      }
    } finally {
      laser.close();
    }
  }

  @Test
  void saysThatAnotherDeviceIsNoLaser() throws IOException {
    AntennaTrajectory path = AntennaTrajectory.fixed(new GeoPosition(50, 10, 100));
    try (DeviceEmulator gps =
            new DeviceEmulator("gps", 0, new NmeaDevice(path, 38_400, Duration.ZERO), clock);
        LmsImpl driver = driverAt(gps)) {
      await().until(() -> number(driver, "dropped_bytes") > 500);
      assertThat(driver.readiness()).isEqualTo(Readiness.INITIALIZING);
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(driver::scan)
                      .hasMessageContaining(
                          "is INITIALIZING: " + gps.url() + " is open, the laser does not"));
    }
  }

  @Test
  void describesItself() throws IOException {
    try (Laser laser = new Laser(makeup, clock);
        LmsImpl driver = laser.driver()) {
      awaitReadiness(driver, Readiness.READY);
      assertThat(driver.attributes())
          .contains(
              new RangeAttributes(0, 8182 * 0.001, Math.PI, Math.toRadians(0.5), 0.005),
              new LmsAttributes("LMS200;30106;V02.30", "V02.30", 38_400, 0, 100))
          .hasAtLeastOneElementOfType(SensorAttributes.class);
      assertThat(driver.updateRate()).isCloseTo(5.2, within(0.1));
    }
  }

  private LmsImpl driverAt(DeviceEmulator emulator) throws IOException {
    emulator.start();
    LmsImpl driver = Laser.driverAt(emulator.url(), clock);
    driver.start();
    return driver;
  }

  private static int beams(LmsImpl driver) {
    try {
      return driver.scan().beams();
    } catch (NotReadyException e) {
      return 0;
    }
  }

  private static Subscription listen(LmsImpl driver, List<RangeScan> scans) {
    return driver.subscribe(
        delivery -> {
          if (delivery.event() instanceof NewReading reading
              && reading.reading() instanceof RangeScan scan) {
            scans.add(scan);
          }
        },
        DeliveryPolicy.keepLast(100));
  }
}
