package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.sim.physics.DrivetrainPhysics;

/** The wheels of a robot, as their controller moves and measures them. */
final class SimulatedDrivetrain implements DrivetrainPhysics {

  private final World world;
  private final SkidSteerBody body;

  SimulatedDrivetrain(World world, SkidSteerBody body) {
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
          row[at + SkidSteerBody.DISTANCE],
          row[at + SkidSteerBody.YAW],
          row[at + SkidSteerBody.SPEED],
          row[at + SkidSteerBody.YAW_RATE]);
    }
  }
}
