package org.dfra.sim.device.drive;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.drive.rflex.RflexBatteryImpl;
import org.dfra.drivers.drive.rflex.RflexDriveImpl;
import org.dfra.drivers.drive.rflex.RflexOdometryImpl;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.time.LockStep;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/**
 * The three real drivers and an emulated controller, in lock-step: every time in here is simulated,
 * and the same in every run.
 */
@Timeout(120)
abstract class RflexInLockStep {

  static final Instant BEGIN = Instant.parse("2026-01-21T07:33:29Z");

  /** The requirement. */
  static final Duration STANDS_WITHIN = Duration.ofMillis(500);

  static final Duration TENTH = Duration.ofMillis(100);

  final LockStep time = new LockStep(BEGIN);
  final RecordedWheels wheels = new RecordedWheels(BEGIN);
  double voltage = 25.2;
  RflexDevice device = controller(0, 0);
  SimPort port = new SimPort("rflex", device, time);
  final RflexDriveImpl drive = new RflexDriveImpl(context("drive", Map.of()));
  final RflexOdometryImpl odometry = new RflexOdometryImpl(context("odometry", Map.of()));
  final RflexBatteryImpl battery = new RflexBatteryImpl(context("battery", Map.of()));

  RflexDevice controller(int first, int firstTurn) {
    return new RflexDevice(wheels, now -> new Charge(voltage, 0, 0.5), first, firstTurn);
  }

  ModuleContext context(String name, Map<String, String> parameters) {
    Map<String, String> all = new HashMap<>(Map.of("link", "sim:rflex"));
    all.putAll(parameters);
    return new ModuleContext(
        "atrv1",
        name,
        Parameters.of("atrv1/" + name, all),
        time,
        StateStore.inMemory(),
        LeaseTerms.DEFAULT,
        time);
  }

  @BeforeEach
  void start() {
    port.start();
  }

  @AfterEach
  void end() {
    drive.close();
    odometry.close();
    battery.close();
    port.close();
  }

  void startAll() {
    drive.start();
    odometry.start();
    battery.start();
    comesTo(drive, Readiness.READY);
    comesTo(odometry, Readiness.READY);
    comesTo(battery, Readiness.READY);
  }

  void comesTo(ModuleImpl module, Readiness readiness) {
    boolean serves = readiness.serves();
    assertThat(
            time.advanceUntil(
                () -> serves ? module.readiness().serves() : module.readiness() == readiness,
                Duration.ofSeconds(30)))
        .as("%s is %s", module, module.readiness())
        .isTrue();
  }

  /** The commander, with the brake released. */
  CommandKey commander() throws Exception {
    CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(30));
    drive.execute(lease.key(), new Brake(false));
    time.advance(TENTH);
    return lease.key();
  }

  /** When the wheels stand; the time goes on until then. */
  Instant standsAt() {
    assertThat(time.advanceUntil(() -> wheels.stand(time.instant()), Duration.ofSeconds(5)))
        .as("they stand")
        .isTrue();
    return Objects.requireNonNull(wheels.standingSince(time.instant()));
  }

  @Nullable Instant lastMotionOrNull() {
    return device.lastMotion();
  }

  Instant lastMotion() {
    return Objects.requireNonNull(lastMotionOrNull(), "nothing has moved");
  }

  void driveOn(CommandKey key, Velocity velocity, Duration duration) {
    Instant end = time.instant().plus(duration);
    while (time.instant().isBefore(end)) {
      drive.execute(key, velocity);
      time.advance(TENTH);
    }
  }
}
