package org.dfra.sim.world;

import java.time.Instant;
import java.util.Objects;
import org.dfra.sim.physics.BatteryPhysics;

/** The battery of a robot, measured at its terminals. */
final class SimulatedBattery implements BatteryPhysics {

  private final World world;
  private final int offset;

  SimulatedBattery(World world, VehicleBody body) {
    this.world = world;
    this.offset = Objects.requireNonNull(body.battery, "a robot with a battery").offset;
  }

  @Override
  public Charge at(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      return new Charge(
          row[offset + BatteryModel.VOLTAGE],
          row[offset + BatteryModel.CURRENT],
          row[offset + BatteryModel.REMAINING]);
    }
  }
}
