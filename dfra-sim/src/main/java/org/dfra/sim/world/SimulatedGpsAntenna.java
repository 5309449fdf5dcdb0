package org.dfra.sim.world;

import java.time.Instant;
import org.dfra.geometry.LocalPosition;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.OutageProcess;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.MutableTransform;

/**
 * Measured position of a receiver's antenna: true position, a slowly changing error, which
 * averaging does not remove, and white noise. Its velocity is that of the antenna, including its
 * lever arm in the robot's yaw, and a little white noise.
 */
final class SimulatedGpsAntenna implements AntennaTrajectory {

  /** Random numbers per step. */
  private static final int EACH = 5;

  private final World world;
  private final DeviceMount mount;
  private final RandomStream draws;
  private final CorrelatedNoise biasEast;
  private final CorrelatedNoise biasNorth;
  private final CorrelatedNoise biasUp;
  private final OutageProcess outages;
  private final double white;
  private final double vertical;
  private final double velocity;

  SimulatedGpsAntenna(
      World world, DeviceMount mount, DeviceDescription device, RandomStream draws) {
    VehicleType type = mount.body().vehicle.type();
    this.world = world;
    this.mount = mount;
    this.draws = draws.substream("white");
    this.white = device.parameter("white_noise_sigma", type);
    this.vertical = device.parameter("vertical_factor", type);
    this.velocity = device.parameter("velocity_sigma", type);
    double sigma = device.parameter("bias_sigma", type);
    double time = device.parameter("bias_correlation_time", type);
    double step = World.STEP_SECONDS;
    this.biasEast = CorrelatedNoise.gaussMarkov(draws.substream("bias_east"), sigma, time, step);
    this.biasNorth = CorrelatedNoise.gaussMarkov(draws.substream("bias_north"), sigma, time, step);
    this.biasUp =
        CorrelatedNoise.gaussMarkov(draws.substream("bias_up"), sigma * vertical, time, step);
    this.outages =
        new OutageProcess(
            draws.substream("outages"),
            device.parameter("outages_per_hour", type),
            device.parameter("mean_outage_duration", type));
  }

  @Override
  public AntennaState at(Instant time) {
    synchronized (world.monitor()) {
      long step = world.stepAt(time);
      double[] row = world.row(step);
      MutableTransform antenna = mount.at(row);
      int at = mount.body().offset;
      double rate = row[at + VehicleBody.RATE];
      double eastward =
          row[at + VehicleBody.EASTWARD]
              - rate * (antenna.north - row[at + VehicleBody.NORTH])
              + velocity * draws.gaussian(EACH * step);
      double northward =
          row[at + VehicleBody.NORTHWARD]
              + rate * (antenna.east - row[at + VehicleBody.EAST])
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
  public boolean hasSatellites(Instant time) {
    synchronized (world.monitor()) {
      return !outages.isActive(world.stepAt(time) * World.STEP_SECONDS);
    }
  }

  /** Degrees from north, clockwise, 0 to less than 360. */
  private static double course(double eastward, double northward) {
    double degrees = Math.toDegrees(StrictMath.atan2(eastward, northward));
    double positive = degrees < 0 ? degrees + 360 : degrees;
    return positive >= 360 ? 0 : positive;
  }
}
