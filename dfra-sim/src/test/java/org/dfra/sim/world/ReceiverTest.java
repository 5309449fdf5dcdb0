package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.junit.jupiter.api.Test;

/** The robot stands at (30, 20) and heads east. */
class ReceiverTest {

  private static DeviceDescription perfect(String name, MountPose mount) {
    return new DeviceDescription(DeviceKind.GPS, name, mount)
        .with("white_noise_sigma", 0)
        .with("bias_sigma", 0)
        .with("velocity_sigma", 0);
  }

  private static World world(VehicleDescription robot) {
    return World.of(field(1).with(robot), START);
  }

  private static LocalPosition found(World world, String gps, double seconds) {
    AntennaTrajectory antenna = world.robot("atrv1").antenna(gps);
    return world.frame().toLocal(antenna.at(after(seconds)).position());
  }

  @Test
  void withoutNoiseItIsWhereItsAntennaIs() {
    World world = world(ugv("atrv1").with(perfect("gps", MountPose.at(0.3, 0.1, 0.6))));
    LocalPosition found = found(world, "gps", 1);
    assertThat(found.east()).isCloseTo(30.3, within(1e-6));
    assertThat(found.north()).isCloseTo(20.1, within(1e-6));
    assertThat(found.up()).isCloseTo(0.6, within(1e-6));
  }

  /**
   * Turning at 0.5 rad/s to the left, an antenna 0.4 m to the left moves backwards against the 1
   * m/s of its robot by 0.2 m/s, one 0.4 m ahead to the left by 0.2 m/s.
   */
  @Test
  void itsVelocityIsThatOfTheAntenna() {
    World world =
        world(
            ugv("atrv1")
                .with(perfectDrive())
                .with(perfect("left", MountPose.at(0, 0.4, 0)))
                .with(perfect("ahead", MountPose.at(0.4, 0, 0))));
    world.robot("atrv1").drivetrain("drive").drive(START, 1, 0.5, 1e9, 1e9);
    double t = 4;
    double yaw = world.groundTruth().pose("atrv1", after(t)).yaw();
    AntennaState left = world.robot("atrv1").antenna("left").at(after(t));
    AntennaState ahead = world.robot("atrv1").antenna("ahead").at(after(t));
    // A step's displacement is along its middle, half a step's turn of 0.0025 rad behind; across
    // the 0.2 m/s of the antenna around the robot that makes 0.0005 m/s.
    assertThat(left.speed()).isCloseTo(0.8, within(6e-4));
    assertThat(ahead.speed()).isCloseTo(Math.hypot(1, 0.2), within(6e-4));
    assertThat(off(left.course(), yaw)).isCloseTo(0, within(0.2));
    assertThat(off(ahead.course(), yaw + Math.atan2(0.2, 1))).isCloseTo(0, within(0.2));
  }

  /** Degrees between a course and a direction in the world's frame. */
  private static double off(double course, double direction) {
    return Math.IEEEremainder(course - 90 + Math.toDegrees(direction), 360);
  }

  @Test
  void courseGoesClockwiseFromNorth() {
    for (int degrees = 0; degrees < 360; degrees += 45) {
      double yaw = Math.toRadians(90 - degrees);
      VehicleDescription robot =
          new VehicleDescription("atrv1", ugv("atrv1").type(), 30, 20, yaw)
              .with(perfectDrive())
              .with(perfect("gps", MountPose.MIDDLE));
      World world = world(robot);
      world.robot("atrv1").drivetrain("drive").drive(START, 1, 0, 1e9, 1e9);
      double course = world.robot("atrv1").antenna("gps").at(after(1)).course();
      assertThat(Math.IEEEremainder(course - degrees, 360)).isCloseTo(0, within(1e-6));
    }
  }

  /** Of 4000 positions the mean is known to σ/63, σ to σ/89; four times that is allowed. */
  @Test
  void whiteNoiseIsNewWithEachPosition() {
    World world =
        world(ugv("atrv1").with(perfect("gps", MountPose.MIDDLE).with("white_noise_sigma", 0.6)));
    double[] east = new double[4000];
    double[] north = new double[4000];
    double[] up = new double[4000];
    for (int i = 0; i < 4000; i++) {
      LocalPosition found = found(world, "gps", i * 0.2);
      east[i] = found.east() - 30;
      north[i] = found.north() - 20;
      up[i] = found.up();
    }
    for (double[] one : new double[][] {east, north}) {
      assertThat(Statistics.mean(one)).isCloseTo(0, within(0.6 / 63 * 4));
      assertThat(Statistics.sigma(one)).isCloseTo(0.6, within(0.6 / 89 * 4));
      assertThat(Statistics.correlation(one, 1)).isCloseTo(0, within(4 / 63.0));
    }
    assertThat(Statistics.sigma(up)).isCloseTo(0.9, within(0.9 / 89 * 4));
  }

  /**
   * 500 receivers, whose biases are independent: their σ is known to 3.2 %, the correlation of all
   * with themselves after a correlation time to 0.04; four times that is allowed.
   */
  @Test
  void biasChangesSlowly() {
    VehicleDescription robot = ugv("atrv1");
    for (int i = 0; i < 500; i++) {
      robot =
          robot.with(
              perfect("gps_" + i, MountPose.MIDDLE)
                  .with("bias_sigma", 1.5)
                  .with("bias_correlation_time", 20));
    }
    World world = world(robot);
    double[] first = new double[500];
    double[] next = new double[500];
    double product = 0;
    for (int i = 0; i < 500; i++) {
      first[i] = found(world, "gps_" + i, 0).east() - 30;
    }
    for (int i = 0; i < 500; i++) {
      next[i] = found(world, "gps_" + i, 20).east() - 30;
      product += first[i] * next[i] / 500;
      assertThat(found(world, "gps_" + i, 20.2).east() - 30)
          .as("0.2 s later it is nearly the same: its change has a σ of 0.21 m")
          .isCloseTo(next[i], within(1.1));
    }
    assertThat(Statistics.mean(first)).isCloseTo(0, within(1.5 * 0.18));
    assertThat(Statistics.sigma(first)).isCloseTo(1.5, within(1.5 * 0.128));
    assertThat(Statistics.sigma(next)).isCloseTo(1.5, within(1.5 * 0.128));
    double correlation = product / (Statistics.sigma(first) * Statistics.sigma(next));
    assertThat(correlation).isCloseTo(Math.exp(-1), within(0.17));
  }

  /** The speed of one that stands is Rayleigh distributed: its mean is σ √(π/2), here to 1.7 %. */
  @Test
  void velocityHasItsOwnNoise() {
    World world =
        world(ugv("atrv1").with(perfect("gps", MountPose.MIDDLE).with("velocity_sigma", 0.05)));
    double[] speeds = new double[1000];
    for (int i = 0; i < 1000; i++) {
      speeds[i] = world.robot("atrv1").antenna("gps").at(after(i)).speed();
    }
    double mean = 0.05 * Math.sqrt(Math.PI / 2);
    assertThat(Statistics.mean(speeds)).isCloseTo(mean, within(mean * 0.068));
  }

  /** Sixty an hour of 6 s are a tenth of the time; of 600 that is known to 6 %. */
  @Test
  void losesTheSkyNowAndThen() {
    World world =
        world(
            ugv("atrv1")
                .with(
                    perfect("gps", MountPose.MIDDLE)
                        .with("outages_per_hour", 60)
                        .with("mean_outage_duration", 6))
                .with(perfect("always", MountPose.MIDDLE)));
    int out = 0;
    for (int i = 0; i < 36_000; i++) {
      out += world.robot("atrv1").antenna("gps").hasSatellites(after(i)) ? 0 : 1;
      assertThat(world.robot("atrv1").antenna("always").hasSatellites(after(i))).isTrue();
    }
    assertThat(out / 36_000.0).isCloseTo(0.1, within(0.024));
  }
}
