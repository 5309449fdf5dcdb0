package org.dfra.sim.device.gyro;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitReadiness;
import static org.dfra.sim.device.Modules.awaitRecovered;
import static org.dfra.sim.device.Modules.number;
import static org.dfra.sim.device.Modules.parameter;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gyro.kvh.Dsp3000Impl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.persona.SensorAttributes;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.physics.GyroInput;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The real driver and the emulated gyro over TCP; both use a clock twice as fast. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class Dsp3000DriverTest {

  private final InstantSource clock = FastClock.of(2);
  private volatile double rate = 0.25;
  private DeviceEmulator emulator;
  private Dsp3000Impl gyro;

  @BeforeEach
  void start() throws IOException {
    emulator = emulated(time -> rate, Duration.ZERO);
    gyro = driver(emulator.url());
    gyro.start();
  }

  @AfterEach
  void end() {
    gyro.close();
    emulator.close();
  }

  @Test
  void reportsHowTheRobotRotates() throws Exception {
    awaitReadiness(gyro, Readiness.READY);
    List<AngularRate> reported = new CopyOnWriteArrayList<>();
    try (Subscription unused = listen(reported)) {
      await().until(() -> reported.size() > 50);
      // A line has six decimals of a degree per second.
      assertThat(reported).allMatch(each -> Math.abs(each.rate() - 0.25) < 1e-7);
      rate = -3;
      await().until(() -> Math.abs(reported.get(reported.size() - 1).rate() + 3) < 1e-7);
    }
    assertThat(gyro.attributes())
        .contains(
            new SensorAttributes(
                "AngularRate",
                List.of("rate"),
                100,
                100,
                null,
                List.of("It turns no faster than 375°/s.")));
  }

  @Test
  void isNotReadyWhileTheGyroStartsNorWhereItTurnsTooFast() throws IOException {
    try (DeviceEmulator cold = emulated(time -> rate, Duration.ofSeconds(10));
        Dsp3000Impl waiting = driver(cold.url())) {
      waiting.start();
      await()
          .untilAsserted(
              () ->
                  assertThatThrownBy(waiting::rate)
                      .isInstanceOf(NotReadyException.class)
                      .hasMessageEndingWith("the gyro says that its rate is not valid"));
      assertThat(waiting.test("validity").passed()).isFalse();
      awaitReadiness(waiting, Readiness.READY);
      awaitPassed(waiting, "validity");
      rate = 7; // rad/s: 401 °/s
      awaitReadiness(waiting, Readiness.INITIALIZING);
      rate = 6;
      awaitReadiness(waiting, Readiness.READY);
    }
  }

  @Test
  void findsItsBiasWhileItStands() throws IOException {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    double bias = Math.toRadians(-0.1);
    GyroInput standing = time -> bias + Math.toRadians(0.02) * random.nextGaussian();
    try (DeviceEmulator still = emulated(standing, Duration.ZERO);
        Dsp3000Impl biased = driver(still.url())) {
      biased.start();
      awaitReadiness(biased, Readiness.READY);
      await("-Ddfra.seed=" + seed)
          .until(() -> biased.recover("calibrate_bias_while_stationary"), Diagnosis::passed);
      assertThat(Double.parseDouble(parameter(biased, "bias")))
          .as("-Ddfra.seed=%d", seed)
          .isCloseTo(bias, within(Math.toRadians(0.006))); // six deviations of the mean
    }
    awaitReadiness(gyro, Readiness.READY);
    assertThat(gyro.recover("calibrate_bias_while_stationary").passed())
        .as("this one turns")
        .isFalse();
  }

  @Test
  void comesBackWhenTheCableWasPulledAndPutBack() {
    awaitReadiness(gyro, Readiness.READY);
    emulator.cable().unplug();
    awaitReadiness(gyro, Readiness.INITIALIZING);
    awaitNoLink(gyro);
    emulator.cable().restore();
    awaitRecovered(gyro, "reopen_link");
    awaitReadiness(gyro, Readiness.READY);
    assertThat(gyro.tests()).containsExactly("link", "readings", "validity");
    awaitPassed(gyro);
  }

  @Test
  void noticesASilentGyroAndItsReturn() {
    awaitReadiness(gyro, Readiness.READY);
    emulator.cable().mute();
    awaitReadiness(gyro, Readiness.INITIALIZING);
    emulator.cable().restore();
    awaitReadiness(gyro, Readiness.READY);
  }

  @Test
  void readsOnThroughAStormOfGarbage() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    emulator.cable().injectNoiseBursts(seed);
    await("-Ddfra.seed=" + seed).until(() -> number(gyro, "dropped_bytes") > 10_000);
    emulator.cable().restore();
    await("-Ddfra.seed=" + seed).until(gyro::readiness, Readiness.READY::equals);
    await("-Ddfra.seed=" + seed).until(() -> Math.abs(gyro.rate().rate() - 0.25) < 1e-7);
  }

  private Subscription listen(List<AngularRate> reported) {
    return gyro.subscribe(
        delivery -> {
          if (delivery.event() instanceof NewReading reading
              && reading.reading() instanceof AngularRate each) {
            reported.add(each);
          }
        },
        DeliveryPolicy.keepLast(100));
  }

  private DeviceEmulator emulated(GyroInput view, Duration warmUp) throws IOException {
    DeviceEmulator made =
        new DeviceEmulator("gyro", 0, new Dsp3000Device(view, 38_400, warmUp), clock);
    made.start();
    return made;
  }

  private Dsp3000Impl driver(String link) {
    return new Dsp3000Impl(
        new ModuleContext(
            "atrv1",
            "gyro",
            Parameters.of("atrv1/gyro", Map.of("link", link, "reopen_max_delay", "1")),
            clock));
  }
}
