package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.device;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.junit.jupiter.api.Test;

class GyroTest {

  private static DeviceDescription gyro(
      String name, double biasSigma, double drift, double whiteSigma) {
    return device(DeviceKind.GYRO, name)
        .with("bias_sigma", biasSigma)
        .with("bias_random_walk", drift)
        .with("white_noise_sigma", whiteSigma);
  }

  private static World world(VehicleDescription robot) {
    return World.of(field(1).with(robot), START);
  }

  private static double rate(World world, String gyro, double seconds) {
    return world.robot("atrv1").gyro(gyro).rate(after(seconds));
  }

  @Test
  void feelsTheTurnOfTheBodyAndNotOfTheWheels() {
    DeviceDescription upsideDown =
        new DeviceDescription(DeviceKind.GYRO, "down", new MountPose(0, 0, 0, Math.PI, 0, 0))
            .with("bias_sigma", 0)
            .with("bias_random_walk", 0)
            .with("white_noise_sigma", 0);
    World world =
        world(
            ugv("atrv1")
                .with(perfectDrive().with("yaw_slip", 0.2))
                .with(gyro("gyro", 0, 0, 0))
                .with(upsideDown));
    world.robot("atrv1").drivetrain("drive").drive(START, 0, 0.5, 1e9, 1e9);
    assertThat(rate(world, "gyro", 2)).isCloseTo(0.4, within(1e-9));
    assertThat(rate(world, "down", 2)).isCloseTo(-0.4, within(1e-9));
  }

  /** Of 4000 readings the mean is known to σ/63, σ to σ/89; four times that is allowed. */
  @Test
  void whiteNoiseIsNewWithEachReading() {
    World world = world(ugv("atrv1").with(gyro("gyro", 0, 0, 0.003)));
    double[] rates = new double[4000];
    for (int i = 0; i < 4000; i++) {
      rates[i] = rate(world, "gyro", i * 0.01);
    }
    assertThat(Statistics.mean(rates)).isCloseTo(0, within(0.003 / 63 * 4));
    assertThat(Statistics.sigma(rates)).isCloseTo(0.003, within(0.003 / 89 * 4));
    assertThat(Statistics.correlation(rates, 1)).isCloseTo(0, within(4 / 63.0));
  }

  /** 500 gyros: σ is known to 3.2 %; after 25 s a walk of 0.001 /√s has added 0.005 to each. */
  @Test
  void biasIsThereFromTheStartAndWanders() {
    VehicleDescription robot = ugv("atrv1");
    for (int i = 0; i < 500; i++) {
      robot = robot.with(gyro("gyro_" + i, 0.02, 0.001, 0));
    }
    World world = world(robot);
    double[] first = new double[500];
    double[] change = new double[500];
    for (int i = 0; i < 500; i++) {
      first[i] = rate(world, "gyro_" + i, 0);
    }
    for (int i = 0; i < 500; i++) {
      change[i] = rate(world, "gyro_" + i, 25) - first[i];
    }
    assertThat(Statistics.sigma(first)).isCloseTo(0.02, within(0.02 * 0.128));
    assertThat(Statistics.mean(first)).isCloseTo(0, within(0.02 / 22 * 4));
    assertThat(Statistics.sigma(change)).isCloseTo(0.005, within(0.005 * 0.128));
  }
}
