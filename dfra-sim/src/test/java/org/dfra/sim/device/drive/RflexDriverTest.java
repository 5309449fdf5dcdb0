package org.dfra.sim.device.drive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Map;
import org.dfra.drivers.drive.rflex.RflexOdometryImpl;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.sensor.Odometry;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.DriveAttributes;
import org.dfra.persona.EffectorAttributes;
import org.dfra.persona.SensorAttributes;
import org.junit.jupiter.api.Test;

/**
 * What the three drivers do with their controller while nothing worse befalls it than a restart.
 */
class RflexDriverTest extends RflexInLockStep {

  @Test
  void drivesCountsAndMeasures() throws Exception {
    startAll();
    assertThat(drive.driveState().parkingBrakeEngaged()).as("as after it was switched on").isTrue();
    CommandKey key = commander();
    assertThat(drive.driveState().parkingBrakeEngaged()).isFalse();
    driveOn(key, new Velocity(0.5, 0.25), Duration.ofSeconds(8));

    assertThat(wheels.travel(time.instant()).speed()).isCloseTo(0.5, within(2e-5));
    assertThat(wheels.travel(time.instant()).yawRate()).isCloseTo(0.25, within(2e-5));
    Odometry reported = odometry.odometry();
    assertThat(reported.frame()).isEqualTo("atrv1/odom");
    assertThat(reported.childFrame()).isEqualTo("atrv1/base_link");
    assertThat(reported.speed()).isCloseTo(0.5, within(2e-5));
    assertThat(reported.yawRate()).isCloseTo(0.25, within(2e-5));
    // It goes round a circle of 2 m to the left; while it comes up to speed, in half a second and
    // an eighth, its wheels are on another curve, which is less than a centimetre.
    assertThat(reported.yaw()).isBetween(1.9, 2.0);
    assertThat(reported.x()).isCloseTo(2 * Math.sin(reported.yaw()), within(0.1));
    assertThat(reported.y()).isCloseTo(2 * (1 - Math.cos(reported.yaw())), within(0.1));
    // 25.2 V less 1.2 V, reported in hundredths
    assertThat(battery.battery().voltage()).isCloseTo(25.2, within(0.005));
    assertThat(battery.battery().remaining()).isCloseTo(0.75, within(0.01));
    assertThat(battery.battery().isEstimated()).isTrue();
    assertThat(device.malformedFrames()).isZero();
    assertThat(drive.history().failures()).isZero();
  }

  @Test
  void aControllerThatWasSwitchedOffAndOnIsNotDrivenOnAndThePoseGoesOn() throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(0.5, 0), Duration.ofSeconds(4));
    drive.execute(key, Velocity.ZERO);
    time.advance(Duration.ofSeconds(1));
    Odometry before = odometry.odometry();
    assertThat(before.x()).isGreaterThan(1.5);

    device = controller(0, 0);
    port.cable().replace(device);
    time.advance(Duration.ofSeconds(2));
    assertThat(odometry.odometry().x()).isCloseTo(before.x(), within(1e-9));
    assertThat(restarts()).isEqualTo("2"); // of both axes
    assertThat(drive.driveState().parkingBrakeEngaged()).as("it is set after power-on").isTrue();
    assertThatThrownBy(() -> drive.execute(key, new Velocity(0.5, 0)))
        .isInstanceOf(BrakeEngagedException.class)
        .hasMessage("atrv1/drive has its brake set, and does not move until that is released");

    drive.execute(key, new Brake(false));
    time.advance(TENTH);
    driveOn(key, new Velocity(0.5, 0), Duration.ofSeconds(2));
    assertThat(odometry.odometry().x()).isCloseTo(before.x() + 0.875, within(0.06));
  }

  private String restarts() {
    return odometry.parameters().stream()
        .filter(each -> each.name().equals("controller_restarts"))
        .findFirst()
        .orElseThrow()
        .value();
  }

  @Test
  void countsOnWhereTheControllersCountWrapsAround() throws Exception {
    device = controller(Integer.MAX_VALUE - 40_000, Integer.MIN_VALUE + 1000);
    port.cable().replace(device);
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(0.5, -0.25), Duration.ofSeconds(4));
    Odometry reported = odometry.odometry();
    double turn = wheels.travel(time.instant()).yaw();
    assertThat(reported.yaw()).isCloseTo(turn, within(0.03)); // one period of 0.1 s
    assertThat(reported.x() * reported.x() + reported.y() * reported.y()).isGreaterThan(1);
    assertThat(restarts()).isEqualTo("0");
  }

  @Test
  void aPulledCableIsNoRestart() throws Exception {
    startAll();
    CommandKey key = commander();
    driveOn(key, new Velocity(0.5, 0), Duration.ofSeconds(2));
    port.cable().unplug();
    comesTo(odometry, Readiness.INITIALIZING);
    time.advance(Duration.ofSeconds(1));
    port.cable().restore();
    comesTo(odometry, Readiness.READY);
    assertThat(odometry.odometry().x())
        .as("what it rolled on meanwhile is counted")
        .isCloseTo(wheels.travel(time.instant()).distance(), within(1e-4));
    assertThat(restarts()).isEqualTo("0");
  }

  @Test
  void aBrakeCommandIsNotUndoneByAStatusThatWasUnderWay() throws Exception {
    startAll();
    CommandLease lease = drive.acquireCommandLease(Duration.ofSeconds(30));
    for (int i = 0; i < 200; i++) { // at every phase of the status' second
      boolean set = i % 2 == 1;
      drive.execute(lease.key(), new Brake(set));
      time.advance(Duration.ofMillis(7));
      assertThat(drive.driveState().parkingBrakeEngaged()).as("after %d", i).isEqualTo(set);
      time.advance(Duration.ofMillis(30));
      assertThat(drive.driveState().parkingBrakeEngaged()).as("after %d", i).isEqualTo(set);
    }
  }

  @Test
  void sharesOneLinkFromTheFirstModuleToTheLast() {
    startAll();
    drive.close();
    time.advance(Duration.ofSeconds(3));
    assertThat(odometry.readiness()).isEqualTo(Readiness.READY);
    assertThat(battery.history().failures()).isZero();
    odometry.close();
    time.advance(Duration.ofSeconds(3));
    assertThat(battery.battery().voltage()).isCloseTo(25.2, within(0.005));
    battery.close();
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().startsWith("rflex "));
    RflexOdometryImpl again = new RflexOdometryImpl(context("again", Map.of()));
    again.start();
    comesTo(again, Readiness.READY);
    again.close();
  }

  @Test
  void reportsAsOftenAsTheMostCuriousWants() {
    startAll();
    odometry.setParameter("report_period", "0.05");
    assertThat(odometry.updateRate()).isEqualTo(20);
    time.advance(Duration.ofSeconds(1));
    long before = frames();
    time.advance(Duration.ofSeconds(2));
    assertThat(frames() - before).isBetween(80L, 84L); // two axes, and a status a second
  }

  private long frames() {
    return odometry.parameters().stream()
        .filter(each -> each.name().equals("frames"))
        .mapToLong(each -> Long.parseLong(each.value()))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void describesItself() {
    assertThat(drive.attributes())
        .contains(new DriveAttributes(1, 2, 0.78, 0.64))
        .hasAtLeastOneElementOfType(EffectorAttributes.class);
    assertThat(odometry.attributes()).hasAtLeastOneElementOfType(SensorAttributes.class);
    assertThat(drive.preconditions()).isNotEmpty();
  }
}
