package org.dfra.sim.world;

import java.time.Instant;
import java.util.Objects;
import org.dfra.sim.body.BatteryBody;

/** The battery of a robot, measured at its terminals. */
final class ChargeView implements BatteryBody {

  private final World world;
  private final int offset;

  ChargeView(World world, Body body) {
    this.world = world;
    this.offset = Objects.requireNonNull(body.battery, "a robot with a battery").offset;
  }

  @Override
  public Charge at(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      return new Charge(
          row[offset + Accumulator.VOLTAGE],
          row[offset + Accumulator.CURRENT],
          row[offset + Accumulator.REMAINING]);
    }
  }
}
