package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.device;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import org.dfra.sim.physics.DrivetrainPhysics;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.junit.jupiter.api.Test;

/** The robot stands at (30, 20) and heads east. A command given at 0 acts from 10 ms on. */
class DriveTest {

  private static final double AT_ONCE = 1e9; // metres, or radians, per second squared

  private static World world(DeviceDescription drive) {
    return World.of(field(1).with(ugv("atrv1").with(drive)), START);
  }

  private static DrivetrainPhysics drive(World world) {
    return world.robot("atrv1").drivetrain("drive");
  }

  private static GroundTruthPose pose(World world, double seconds) {
    return world.groundTruth().pose("atrv1", after(seconds));
  }

  /**
   * At v and w it goes round a circle of v/w. Its wheels come up to speed evenly from 10 to 20 ms,
   * in which it goes half as far along that circle, so at t it has turned by w (t − 15 ms).
   */
  @Test
  void drivesTheArcThatItsWheelsGive() {
    World world = world(perfectDrive());
    double radius = 0.6 / 0.5;
    drive(world).drive(START, 0.6, 0.5, AT_ONCE, AT_ONCE);
    for (double t : new double[] {0.5, 1, 3.5, 8, 60}) {
      double angle = 0.5 * (t - 0.015);
      GroundTruthPose pose = pose(world, t);
      assertThat(pose.east()).isCloseTo(30 + radius * Math.sin(angle), within(1e-9));
      assertThat(pose.north()).isCloseTo(20 + radius * (1 - Math.cos(angle)), within(1e-9));
      assertThat(Math.IEEEremainder(pose.yaw() - angle, 2 * Math.PI)).isCloseTo(0, within(1e-9));
      assertThat(pose.speed()).isCloseTo(0.6, within(1e-4)); // chord of a step over its time
      assertThat(pose.yawRate()).isCloseTo(0.5, within(1e-9));
    }
  }

  @Test
  void turnsOnTheSpotToTheLeft() {
    World world = world(perfectDrive());
    drive(world).drive(START, 0, 1, AT_ONCE, AT_ONCE);
    GroundTruthPose pose = pose(world, 1.015);
    assertThat(pose.yaw()).isCloseTo(0.995, within(1e-9)); // the state of 1.01 s
    assertThat(pose.east()).isEqualTo(30);
    assertThat(pose.north()).isEqualTo(20);
  }

  /** At an even acceleration a the way is a t²/2. */
  @Test
  void accelerates() {
    World world = world(perfectDrive());
    drive(world).drive(START, 1, 0, 0.5, 1);
    assertThat(pose(world, 1.01).east()).isCloseTo(30 + 0.5 * 1 / 2, within(1e-9));
    assertThat(drive(world).travel(after(1.01)).speed()).isCloseTo(0.5, within(1e-9));
    assertThat(pose(world, 4.01).east()).isCloseTo(30 + 1 + 2, within(1e-9));
    drive(world).drive(after(4.01), 0, 0, 0.5, 1);
    assertThat(pose(world, 7).east()).isCloseTo(30 + 1 + 2.01 + 1, within(1e-9));
    assertThat(pose(world, 7).speed()).isZero();
  }

  /** 1 m/s and 2 rad/s on 0.75 m need 1.75 m/s of the right side; it has 1, so all is 4/7 of it. */
  @Test
  void slowsBothSidesDownAlikeWhenOneIsTooFast() {
    World world = world(perfectDrive().with("max_wheel_speed", 1));
    drive(world).drive(START, 1, 2, AT_ONCE, AT_ONCE);
    DrivetrainPhysics.Travel travel = drive(world).travel(after(1));
    assertThat(travel.speed()).isCloseTo(1 / 1.75, within(1e-12));
    assertThat(travel.yawRate()).isCloseTo(2 / 1.75, within(1e-12));
  }

  /** A side that may gain 2 m/s² is at 1.2 m/s after 0.6 s, whatever the command allows. */
  @Test
  void isNoQuickerThanItsMotors() {
    World world = world(perfectDrive().with("max_acceleration", 2));
    drive(world).drive(START, 5, 0, AT_ONCE, AT_ONCE);
    assertThat(drive(world).travel(after(0.61)).speed()).isCloseTo(1.2, within(1e-9));
  }

  @Test
  void slipsWhileItsWheelsCountOn() {
    World world = world(perfectDrive().with("slip", 0.1).with("yaw_slip", 0.25));
    drive(world).drive(START, 0.5, 0, AT_ONCE, AT_ONCE);
    DrivetrainPhysics.Travel straight = drive(world).travel(after(10));
    assertThat(straight.distance()).isCloseTo(0.5 * 9.985, within(1e-9));
    assertThat(pose(world, 10).east() - 30).isCloseTo(0.9 * straight.distance(), within(1e-9));

    World turning = world(perfectDrive().with("slip", 0.1).with("yaw_slip", 0.25));
    drive(turning).drive(START, 0, 0.5, AT_ONCE, AT_ONCE);
    assertThat(drive(turning).travel(after(4)).yaw()).isCloseTo(0.5 * 3.985, within(1e-9));
    assertThat(pose(turning, 4).yaw()).isCloseTo(0.75 * 0.5 * 3.985, within(1e-9));
  }

  /** A left side that counts 2 % too much seems to go 1 % farther and to turn right. */
  @Test
  void itsEncodersMeasureTheWheelsWithTheirOwnError() {
    World world = world(perfectDrive().with("left_encoder_scale_error", 0.02));
    drive(world).drive(START, 1, 0, AT_ONCE, AT_ONCE);
    DrivetrainPhysics.Travel travel = drive(world).travel(after(10.015));
    double way = pose(world, 10.015).east() - 30;
    assertThat(way).isCloseTo(9.995, within(1e-9));
    assertThat(travel.distance()).isCloseTo(1.01 * way, within(1e-9));
    assertThat(travel.yaw()).isCloseTo(-0.02 * way / 0.75, within(1e-9));
    assertThat(travel.yawRate()).isCloseTo(-0.02 / 0.75, within(1e-9));
  }

  /** From 1 m/s at 4 m/s² it needs 0.25 s and 0.125 m. */
  @Test
  void standsWhenItsBrakesAreSet() {
    World world = world(perfectDrive().with("brake_deceleration", 4));
    drive(world).drive(START, 1, 0, AT_ONCE, AT_ONCE);
    drive(world).brake(after(2), true);
    double before = pose(world, 2.01).east();
    assertThat(pose(world, 2.26).east()).isCloseTo(before + 0.125, within(1e-9));
    drive(world).drive(after(3), -1, 0, AT_ONCE, AT_ONCE);
    assertThat(pose(world, 4).east()).isCloseTo(before + 0.125, within(1e-9));
    drive(world).brake(after(4), false);
    assertThat(pose(world, 5).east()).as("it drives as commanded").isLessThan(before - 0.5);
  }

  @Test
  void standsWithoutCharge() {
    World world =
        World.of(
            field(1)
                .with(
                    ugv("atrv1")
                        .with(perfectDrive())
                        .with(device(DeviceKind.BATTERY, "battery").with("initial_charge", 0))),
            START);
    drive(world).drive(START, 1, 0, AT_ONCE, AT_ONCE);
    assertThat(pose(world, 5).east()).isEqualTo(30);
  }

  @Test
  void commandsActFromTheNextStepOn() {
    World world = world(perfectDrive());
    drive(world).drive(after(0.5), 1, 0, AT_ONCE, AT_ONCE);
    assertThat(pose(world, 0.51).east()).isEqualTo(30);
    assertThat(pose(world, 0.52).east()).isCloseTo(30.005, within(1e-12));
    assertThat(pose(world, 0.529).east()).as("it stands still between two steps").isEqualTo(30.005);
    assertThat(world.groundTruth().lateCommands()).isZero();
    drive(world).drive(after(0.51), 0, 0, AT_ONCE, AT_ONCE);
    assertThat(world.groundTruth().lateCommands()).isEqualTo(1);
    assertThat(pose(world, 0.53).east()).isCloseTo(30.015, within(1e-12));
  }

  @Test
  void answersLateQueriesForTheTimeThatTheyAskFor() {
    World world = world(perfectDrive());
    drive(world).drive(START, 1, 0, AT_ONCE, AT_ONCE);
    double at9 = pose(world, 9).east();
    double at10 = pose(world, 10).east();
    assertThat(pose(world, 9).east()).isEqualTo(at9).isNotEqualTo(at10);
    assertThat(pose(world, 2).east()).as("the oldest kept").isCloseTo(30 + 7.435, within(1e-9));
    assertThat(world.time()).isEqualTo(after(10));
  }

  @Test
  void refusesWhatNoWheelsCanDo() {
    DrivetrainPhysics drive = drive(world(perfectDrive()));
    assertThatThrownBy(() -> drive.drive(START, Double.NaN, 0, 1, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("NaN m/s");
    assertThatThrownBy(() -> drive.drive(START, 1, 0, 0, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("above 0");
  }

  @Test
  void refusesAClockThatLeaps() {
    World world = world(perfectDrive());
    assertThatThrownBy(() -> world.advanceTo(START.plusSeconds(3 * 86_400)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("correct the clock");
    assertThat(world.time()).isEqualTo(START);
  }
}
