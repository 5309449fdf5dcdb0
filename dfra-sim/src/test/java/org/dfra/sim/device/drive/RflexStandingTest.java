package org.dfra.sim.device.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The wheels stop in time, whatever happens to the commander, the cable or the controller. */
class RflexStandingTest extends RflexInLockStep {

  @ParameterizedTest
  @CsvSource({
    "1, 0, 1",
    "-1, 0, 1",
    "1, 2, 3",
    "0.3, -0.6, 1.5",
    "0, 2, 2",
    "0.01, 0, 0.5",
  })
  void standsWithinHalfASecondOfTheLastCommandWhenItsCommanderFallsSilent(
      double speed, double turnRate, double seconds) throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(speed, turnRate), Duration.ofMillis((long) (seconds * 1000)));
    drive.execute(key, new Velocity(speed, turnRate));
    Instant last = time.instant();
    time.advance(TENTH);
    assertThat(standsAt()).isBefore(last.plus(STANDS_WITHIN));
    assertThat(lastMotion()).as("said once, and never again").isBefore(last.plusMillis(50));
    assertThat(drive.driveState().commandTimeouts()).isEqualTo(1);
    assertThat(drive.driveState().velocity()).isEqualTo(Velocity.ZERO);
    time.advance(Duration.ofSeconds(5));
    assertThat(wheels.stand(time.instant())).isTrue();
  }

  @Test
  void stopsAsFastWhenItsCommanderDiesAfterTheStopCommand() throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(1, 0), Duration.ofSeconds(2));
    drive.execute(key, Velocity.ZERO);
    Instant last = time.instant();
    assertThat(standsAt()).isBefore(last.plusMillis(200)); // by 7 m/s²
    assertThat(drive.driveState().commandTimeouts()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"pull", "silence"})
  void standsWithinHalfASecondOfTheLastCommandThatCameWhenTheCableFails(String fault)
      throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(1, 2), Duration.ofSeconds(2));
    drive.execute(key, new Velocity(1, 2));
    time.advance(Duration.ofMillis(50));
    if (fault.equals("pull")) {
      port.cable().unplug();
    } else {
      port.cable().mute();
    }
    Instant last = lastMotion();
    assertThat(standsAt()).isBeforeOrEqualTo(last.plus(STANDS_WITHIN));
    comesTo(drive, Readiness.INITIALIZING);
    assertThatThrownBy(() -> drive.execute(key, new Velocity(1, 0)))
        .isInstanceOf(NotReadyException.class)
        .hasMessageContaining("atrv1/drive is INITIALIZING: it cannot execute Velocity[");

    port.cable().restore();
    comesTo(drive, Readiness.READY);
    time.advance(Duration.ofSeconds(2));
    assertThat(lastMotion()).as("nothing is driven on by itself").isEqualTo(last);
    driveOn(key, new Velocity(0.2, 0), Duration.ofSeconds(1));
    assertThat(wheels.travel(time.instant()).speed()).isCloseTo(0.2, within(2e-5));
  }

  @Test
  void standsBeforeItsLinkIsClosedWhenTheModuleEnds() throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(1, 0), Duration.ofSeconds(2));
    odometry.close();
    battery.close();
    drive.close();
    Instant closed = time.instant();
    assertThat(standsAt())
        .as("long before the controller's own failsafe")
        .isBefore(closed.plusMillis(200));
  }

  @Test
  void standsWhenItsCommanderIsLost() throws Exception {
    startAll();
    CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(30));
    drive.execute(lease.key(), new Brake(false));
    driveOn(lease.key(), new Velocity(1, 0), Duration.ofSeconds(2));
    lease.close();
    Instant closed = time.instant();
    assertThat(standsAt()).isBefore(closed.plusMillis(200));
  }

  @Test
  void ofVelocitiesThatComeTooFastTheNewestIsSentAndNoneIsOld() throws Exception {
    startAll();
    CommandKey key = commander();
    wheels.orders.clear();
    for (int i = 1; i <= 1000; i++) {
      drive.execute(key, new Velocity(i * 1e-3, i * -1e-3)); // all at one instant
    }
    time.advance(TENTH);
    assertThat(wheels.orders).hasSizeLessThanOrEqualTo(4);
    RecordedWheels.Order last = wheels.orders.get(wheels.orders.size() - 1);
    assertThat(last.speed()).isCloseTo(1, within(1e-4));
    assertThat(last.turnRate()).isCloseTo(-1, within(1e-4));

    Instant flooded = time.instant().plusSeconds(1);
    while (time.instant().isBefore(flooded)) { // five times as fast as frames are sent
      drive.execute(key, new Velocity(0.5, 0.5));
      time.advance(Duration.ofMillis(2));
    }
    drive.execute(key, Velocity.ZERO);
    Instant reported = time.instant();
    time.advance(TENTH);
    assertThat(lastMotion()).isBefore(reported.plusMillis(40));
    assertThat(wheels.orders.get(wheels.orders.size() - 1).moves()).isFalse();
    assertThat(device.malformedFrames()).isZero();
  }

  @Test
  void aControllerThatIsSwitchedOffWhileItDrivesIsNotDrivenOn() throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(0.5, 0), Duration.ofSeconds(2));
    device = controller(0, 0);
    port.cable().replace(device);
    driveUntilRefused(key);
    assertThat(drive.driveState().parkingBrakeEngaged()).isTrue();
    assertThat(drive.driveState().velocity()).isEqualTo(Velocity.ZERO);
    assertThat(wheels.stand(time.instant())).isTrue();
    assertThat(lastMotionOrNull()).as("of the new one").isNull();
  }

  private void driveUntilRefused(CommandKey key) {
    Instant end = time.instant().plusSeconds(10);
    assertThatThrownBy(
            () -> {
              while (time.instant().isBefore(end)) {
                drive.execute(key, new Velocity(0.5, 0));
                time.advance(TENTH);
              }
            })
        .hasMessageContaining("has its brake set");
  }

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3})
  void aBadLineNeverKeepsTheWheelsFromStanding(long seed) throws Exception {
    startAll();
    CommandKey key = commander();
    port.cable().corruptBytes(seed, 0.002); // every twentieth frame
    List<Instant> late = new ArrayList<>();
    var watching = time.every(Duration.ofMillis(5), () -> noteUnlessTheyStandInTime(late));
    Random random = new Random(seed);
    Instant end = time.instant().plusSeconds(60);
    while (time.instant().isBefore(end)) {
      try {
        drive.execute(key, new Velocity(random.nextDouble() * 2 - 1, random.nextDouble() * 4 - 2));
      } catch (NotReadyException | IllegalArgumentException e) {
        // the link or the brake; the message names it
      }
      time.advance(random.nextInt(20) == 0 ? Duration.ofSeconds(1) : TENTH);
    }
    time.advance(Duration.ofSeconds(5));
    assertThat(wheels.stand(time.instant())).isTrue();
    assertThat(late).as("seed %d: half a second after the last command that came", seed).isEmpty();
    watching.cancel();
    port.cable().restore();
    time.advance(Duration.ofSeconds(5));
    comesTo(drive, Readiness.READY);
  }

  private void noteUnlessTheyStandInTime(List<Instant> late) {
    Instant last = lastMotionOrNull();
    Instant now = time.instant();
    if (last != null && !now.isBefore(last.plus(STANDS_WITHIN)) && !wheels.stand(now)) {
      late.add(now);
    }
  }
}
