package org.dfra.sim.device.pantilt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.device.Modules.await;
import static org.dfra.sim.device.Modules.awaitNoLink;
import static org.dfra.sim.device.Modules.awaitPassed;
import static org.dfra.sim.device.Modules.awaitRecovered;
import static org.dfra.sim.device.Modules.number;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.pantilt.ptu.PtuImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.Halt;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.FastClock;
import org.dfra.sim.device.Modules;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The real driver and the emulated unit, at 9600 baud over TCP, in real time. */
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class PtuDriverTest {

  private static final double FAST = Math.toRadians(100);

  /** Half a position. */
  private static final double NEAR = Math.toRadians(185.1428 / 3600) / 2 + 1e-9;

  /** Where the head of the world points. */
  private static final class Head {
    volatile double pan;
    volatile double tilt;
  }

  private final Head head = new Head();
  private DeviceEmulator emulator;
  private PtuImpl unit;

  @BeforeEach
  void start() throws IOException {
    emulator = emulated(false, InstantSource.system());
    unit = driver(emulator.url(), InstantSource.system());
    unit.start();
  }

  @AfterEach
  void end() {
    unit.close();
    emulator.close();
  }

  @Test
  void pointsInTheCommandedDirectionAndReportsItsMotion() throws Exception {
    awaitReadiness(Readiness.READY);
    List<PanTiltState> states = new CopyOnWriteArrayList<>();
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofMinutes(5));
        Subscription unused = listen(states)) {
      unit.execute(lease.key(), new PointAt(0.8, -0.4, FAST));
      awaitArrival(0.8, -0.4);
      assertThat(head.pan).isCloseTo(0.8, within(NEAR));
      assertThat(head.tilt).isCloseTo(-0.4, within(NEAR));
      await().until(() -> states.stream().anyMatch(each -> each.isMoving() && each.pan() > 0.1));
      assertThat(unit.localTransform().yaw()).isCloseTo(0.8, within(NEAR));
      assertThat(unit.localTransform().pitch()).as("down").isCloseTo(0.4, within(NEAR));
      unit.execute(lease.key(), new PointAt(-0.2, 0.1, FAST));
      awaitArrival(-0.2, 0.1);
    }
  }

  @Test
  void haltsOnTheWayByCommandAndWhenItsCommanderIsGone() throws Exception {
    awaitReadiness(Readiness.READY);
    double slow = Math.toRadians(5);
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofMinutes(5))) {
      unit.execute(lease.key(), new PointAt(2.5, 0, slow));
      await().until(() -> unit.panTiltState().pan() > 0.05);
      unit.execute(lease.key(), new Halt());
      awaitStandstill();
      assertThat(unit.panTiltState().pan()).isLessThan(2.4);
      unit.execute(lease.key(), new PointAt(-2.5, 0, slow));
      await().until(() -> unit.panTiltState().isMoving());
    }
    awaitStandstill();
    assertThat(head.pan).as("it did not go on to the commanded angle").isGreaterThan(-2.4);
  }

  @Test
  void comesBackWhenTheCableWasPulledAndPutBack() {
    awaitReadiness(Readiness.READY);
    for (int pulled = 1; pulled <= 2; pulled++) {
      emulator.cable().unplug();
      awaitReadiness(Readiness.INITIALIZING);
      assertThatThrownBy(unit::panTiltState).isInstanceOf(NotReadyException.class);
      emulator.cable().restore();
      awaitReadiness(Readiness.READY);
      assertThat(unit.history().failures()).isGreaterThanOrEqualTo(pulled);
    }
  }

  @Test
  void noticesASilentUnitAndItsReturn() throws Exception {
    awaitReadiness(Readiness.READY);
    try (CommandLease lease = unit.acquireCommandLease(Duration.ofMinutes(5))) {
      emulator.cable().mute();
      awaitReadiness(Readiness.INITIALIZING);
      assertThatThrownBy(() -> unit.execute(lease.key(), new PointAt(0, 0, 1)))
          .isInstanceOf(NotReadyException.class);
      emulator.cable().restore();
      await().until(() -> unit.readiness() == Readiness.ACTIVE);
    }
  }

  @Test
  void getsOverAStormOfGarbage() {
    awaitReadiness(Readiness.READY);
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    emulator.cable().injectNoiseBursts(seed);
    await("-Ddfra.seed=" + seed).until(() -> number(unit, "dropped_bytes") > 5_000);
    emulator.cable().restore();
    // Noise that reads !P is taken for a limit, and then the direction of the head is unknown.
    await("-Ddfra.seed=" + seed)
        .until(
            () ->
                unit.readiness() == Readiness.READY
                    || (unit.readiness() == Readiness.FAILED
                        && unit.recover("reset_by_moving").passed()));
    await("-Ddfra.seed=" + seed)
        .until(() -> unit.panTiltState().pan() == 0 && unit.panTiltState().tilt() == 0);
  }

  @Test
  void waitsForAUnitThatIsJustSwitchedOn() throws IOException {
    InstantSource fast = FastClock.of(5);
    try (DeviceEmulator cold = emulated(true, fast);
        PtuImpl patient = driver(cold.url(), fast)) {
      patient.start();
      assertThat(patient.readiness()).isEqualTo(Readiness.INITIALIZING);
      await().until(() -> patient.readiness() == Readiness.READY);
      assertThat(patient.panTiltState().pan()).isZero();
    }
  }

  @Test
  void passesItsTestsWhenAllIsWellAndFailsThemWhenNot() {
    awaitReadiness(Readiness.READY);
    assertThat(unit.tests()).containsExactly("link", "readings", "identification");
    awaitPassed(unit);
    assertThat(awaitPassed(unit, "identification").finding())
        .isEqualTo("it says it is Pan-Tilt Controller v1.10 (EMULATOR)");
    emulator.cable().unplug();
    awaitReadiness(Readiness.INITIALIZING);
    awaitNoLink(unit);
    for (String test : unit.tests()) {
      assertThat(unit.test(test).passed()).as(test).isFalse();
    }
    assertThat(unit.recover("reset_by_moving").passed()).isFalse();
    emulator.cable().restore();
    awaitRecovered(unit, "reopen_link");
    awaitReadiness(Readiness.READY);
  }

  @Test
  void isResetByMoving() throws Exception {
    InstantSource fast = FastClock.of(5);
    try (DeviceEmulator quick = emulated(false, fast);
        PtuImpl reset = driver(quick.url(), fast)) {
      reset.start();
      await().until(() -> reset.readiness() == Readiness.READY);
      try (CommandLease lease = reset.acquireCommandLease(Duration.ofMinutes(5))) {
        reset.execute(lease.key(), new PointAt(0.3, 0.2, FAST));
        await().until(() -> head.pan > 0.1 && head.tilt > 0.1);
      }
      Diagnosis done = awaitRecovered(reset, "reset_by_moving");
      assertThat(done.finding()).contains("points to 0, 0");
      assertThat(head.pan).isZero();
      assertThat(head.tilt).isZero();
      await().until(() -> reset.readiness() == Readiness.READY);
    }
  }

  private Subscription listen(List<PanTiltState> states) {
    return unit.subscribe(
        delivery -> {
          if (delivery.event() instanceof NewReading reading
              && reading.reading() instanceof PanTiltState state) {
            states.add(state);
          }
        },
        DeliveryPolicy.keepLast(100));
  }

  private void awaitArrival(double pan, double tilt) {
    await()
        .until(
            () -> {
              PanTiltState now = unit.panTiltState();
              return !now.isMoving()
                  && Math.abs(now.pan() - pan) < NEAR
                  && Math.abs(now.tilt() - tilt) < NEAR;
            });
  }

  private void awaitStandstill() {
    await()
        .until(
            () -> {
              PanTiltState now = unit.panTiltState();
              await()
                  .until(
                      () -> unit.panTiltState().measured().isAfter(now.measured().plusMillis(200)));
              return !now.isMoving() && unit.panTiltState().pan() == now.pan();
            });
  }

  private DeviceEmulator emulated(boolean resets, InstantSource clock) throws IOException {
    PtuDevice device =
        new PtuDevice(
            (time, pan, tilt) -> {
              head.pan = pan;
              head.tilt = tilt;
            },
            9600,
            resets);
    DeviceEmulator made = new DeviceEmulator("ptu", 0, device, clock);
    made.start();
    return made;
  }

  private static PtuImpl driver(String link, InstantSource clock) {
    return new PtuImpl(
        new ModuleContext(
            "atrv1",
            "pan_tilt",
            Parameters.of("atrv1/pan_tilt", Map.of("link", link, "reopen_max_delay", "1")),
            clock,
            StateStore.inMemory(),
            Modules.LONG_LEASES,
            Scheduler.system()));
  }

  private void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(unit, expected);
  }
}
