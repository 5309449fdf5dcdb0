package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.body.TurnView;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleType;
import org.dfra.sim.world.noise.Draws;
import org.dfra.sim.world.noise.Drift;

/**
 * A rate gyro: the turn of its robot about its own z axis, an error from the start that wanders,
 * and white noise. How fast a body leans over on rough ground or a head pans it does not feel.
 */
final class GyroView implements TurnView {

  private final World world;
  private final Rig rig;
  private final Drift bias;
  private final Draws draws;
  private final double white;

  GyroView(World world, Rig rig, DeviceDescription device, Draws draws) {
    VehicleType type = rig.body().vehicle.type();
    this.world = world;
    this.rig = rig;
    this.draws = draws.of("white");
    this.white = device.parameter("white", type);
    double first = device.parameter("bias", type) * draws.of("bias").gaussian(0);
    this.bias =
        Drift.walk(draws.of("drift"), first, device.parameter("drift", type), World.STEP_SECONDS);
  }

  @Override
  public double rate(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      double rate = row[rig.body().offset + Body.RATE] * rig.at(row).zz;
      return rate + bias.at(step) + white * draws.gaussian(step);
    }
  }
}
