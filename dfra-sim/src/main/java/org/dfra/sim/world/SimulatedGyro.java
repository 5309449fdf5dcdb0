package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.physics.GyroInput;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleType;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.RandomStream;

/**
 * A rate gyro: the yaw rate of its robot about its own z axis, an initial bias that drifts, and
 * white noise. It does not measure roll and pitch rates on rough ground or the motion of a pan-tilt
 * head.
 */
final class SimulatedGyro implements GyroInput {

  private final World world;
  private final DeviceMount rig;
  private final CorrelatedNoise bias;
  private final RandomStream draws;
  private final double white;

  SimulatedGyro(World world, DeviceMount rig, DeviceDescription device, RandomStream draws) {
    VehicleType type = rig.body().vehicle.type();
    this.world = world;
    this.rig = rig;
    this.draws = draws.substream("white");
    this.white = device.parameter("white", type);
    double first = device.parameter("bias", type) * draws.substream("bias").gaussian(0);
    this.bias =
        CorrelatedNoise.walk(
            draws.substream("drift"), first, device.parameter("drift", type), World.STEP_SECONDS);
  }

  @Override
  public double rate(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      double rate = row[rig.body().offset + VehicleBody.RATE] * rig.at(row).zz;
      return rate + bias.at(step) + white * draws.gaussian(step);
    }
  }
}
