package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.body.DriveBody;

/** The wheels of a robot, as their controller moves and measures them. */
final class WheelsView implements DriveBody {

  private final World world;
  private final GroundBody body;

  WheelsView(World world, GroundBody body) {
    this.world = world;
    this.body = body;
  }

  @Override
  public void drive(
      Instant time, double speed, double turnRate, double acceleration, double turnAcceleration) {
    if (!Double.isFinite(speed)
        || !Double.isFinite(turnRate)
        || !(acceleration > 0)
        || !(turnAcceleration > 0)) {
      throw new IllegalArgumentException(
          "wheels cannot be driven at "
              + speed
              + " m/s, "
              + turnRate
              + " rad/s by "
              + acceleration
              + " m/s², "
              + turnAcceleration
              + " rad/s²; give finite speeds and accelerations above 0");
    }
    world.command(time, () -> body.drive(speed, turnRate, acceleration, turnAcceleration));
  }

  @Override
  public void brake(Instant time, boolean set) {
    world.command(time, () -> body.brake(set));
  }

  @Override
  public Travel travel(Instant time) {
    synchronized (world.monitor()) {
      double[] row = world.row(world.stepAt(time));
      int at = body.driveOffset;
      return new Travel(
          row[at + GroundBody.DISTANCE],
          row[at + GroundBody.TURN],
          row[at + GroundBody.SPEED],
          row[at + GroundBody.TURN_RATE]);
    }
  }
}
