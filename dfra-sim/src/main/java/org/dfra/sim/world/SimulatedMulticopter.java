package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.physics.MulticopterPhysics;

/** A multicopter for its autopilot's emulator: state without error. */
final class SimulatedMulticopter implements MulticopterPhysics {

  private final World world;
  private final MulticopterBody body;

  SimulatedMulticopter(World world, MulticopterBody body) {
    this.world = world;
    this.body = body;
  }

  @Override
  public void rotors(Instant time, boolean turn) {
    world.command(time, () -> body.rotors(turn));
  }

  @Override
  public void fly(Instant time, double east, double north, double up, double speed) {
    if (!Double.isFinite(east + north + up) || !(speed > 0)) {
      throw new IllegalArgumentException(
          "the multicopter cannot fly to ("
              + east
              + ", "
              + north
              + ", "
              + up
              + ") m at "
              + speed
              + " m/s; give finite coordinates and a speed above 0");
    }
    world.command(time, () -> body.fly(east, north, up, speed));
  }

  @Override
  public MulticopterState at(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      int at = body.offset;
      return new MulticopterState(
          row[at + VehicleBody.EAST],
          row[at + VehicleBody.NORTH],
          row[at + VehicleBody.UP],
          Math.IEEEremainder(row[at + VehicleBody.YAW], 2 * Math.PI),
          row[at + VehicleBody.EASTWARD],
          row[at + VehicleBody.NORTHWARD],
          row[at + VehicleBody.UPWARD],
          row[body.flightOffset + MulticopterBody.ROTORS] > 0);
    }
  }
}
