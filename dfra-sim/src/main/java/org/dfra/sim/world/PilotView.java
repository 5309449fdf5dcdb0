package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.body.FlightBody;

/** A multicopter, as who tells its autopilot where to go sees it: without error. */
final class PilotView implements FlightBody {

  private final World world;
  private final AirBody body;

  PilotView(World world, AirBody body) {
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
          "nobody can fly to ("
              + east
              + ", "
              + north
              + ", "
              + up
              + ") m at "
              + speed
              + " m/s; give a place and a speed above 0");
    }
    world.command(time, () -> body.fly(east, north, up, speed));
  }

  @Override
  public Flight at(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      int at = body.offset;
      return new Flight(
          row[at + Body.EAST],
          row[at + Body.NORTH],
          row[at + Body.UP],
          Math.IEEEremainder(row[at + Body.YAW], 2 * Math.PI),
          row[at + Body.EASTWARD],
          row[at + Body.NORTHWARD],
          row[at + Body.UPWARD],
          row[body.flightOffset + AirBody.ROTORS] > 0);
    }
  }
}
