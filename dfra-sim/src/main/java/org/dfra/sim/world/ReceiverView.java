package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.AntennaPath;
import org.dfra.sim.device.AntennaState;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleType;
import org.dfra.sim.world.noise.Draws;
import org.dfra.sim.world.noise.Drift;
import org.dfra.sim.world.noise.Spells;
import org.dfra.sim.world.shape.Stance;

/**
 * Where a receiver on a robot finds its antenna to be: a slowly changing error, which it cannot
 * average out, and a new one each time. Its velocity is that of the antenna, which the robot's turn
 * swings around, and a little white noise.
 */
final class ReceiverView implements AntennaPath {

  /** Draws for each step. */
  private static final int EACH = 5;

  private final World world;
  private final Rig rig;
  private final Draws draws;
  private final Drift biasEast;
  private final Drift biasNorth;
  private final Drift biasUp;
  private final Spells outages;
  private final double white;
  private final double vertical;
  private final double velocity;

  ReceiverView(World world, Rig rig, DeviceDescription device, Draws draws) {
    VehicleType type = rig.body().vehicle.type();
    this.world = world;
    this.rig = rig;
    this.draws = draws.of("white");
    this.white = device.parameter("white", type);
    this.vertical = device.parameter("vertical", type);
    this.velocity = device.parameter("velocity", type);
    double sigma = device.parameter("bias", type);
    double time = device.parameter("bias_time", type);
    double step = World.STEP_SECONDS;
    this.biasEast = Drift.gaussMarkov(draws.of("bias_east"), sigma, time, step);
    this.biasNorth = Drift.gaussMarkov(draws.of("bias_north"), sigma, time, step);
    this.biasUp = Drift.gaussMarkov(draws.of("bias_up"), sigma * vertical, time, step);
    this.outages =
        new Spells(
            draws.of("outages"),
            device.parameter("outages", type),
            device.parameter("outage_time", type));
  }

  @Override
  public AntennaState at(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      Stance antenna = rig.at(row);
      int at = rig.body().offset;
      double rate = row[at + Body.RATE];
      double eastward =
          row[at + Body.EASTWARD]
              - rate * (antenna.north - row[at + Body.NORTH])
              + velocity * draws.gaussian(EACH * step);
      double northward =
          row[at + Body.NORTHWARD]
              + rate * (antenna.east - row[at + Body.EAST])
              + velocity * draws.gaussian(EACH * step + 1);
      LocalPosition found =
          new LocalPosition(
              antenna.east + biasEast.at(step) + white * draws.gaussian(EACH * step + 2),
              antenna.north + biasNorth.at(step) + white * draws.gaussian(EACH * step + 3),
              antenna.up + biasUp.at(step) + white * vertical * draws.gaussian(EACH * step + 4));
      return new AntennaState(
          world.frame().toGeo(found),
          Math.sqrt(eastward * eastward + northward * northward),
          course(eastward, northward));
    }
  }

  @Override
  public boolean hasSky(Instant time) {
    synchronized (world.monitor()) {
      return !outages.isOn(world.stepAt(time) * World.STEP_SECONDS);
    }
  }

  /** Degrees from north, clockwise, 0 to less than 360. */
  private static double course(double eastward, double northward) {
    double degrees = Math.toDegrees(StrictMath.atan2(eastward, northward));
    double positive = degrees < 0 ? degrees + 360 : degrees;
    return positive >= 360 ? 0 : positive;
  }
}
