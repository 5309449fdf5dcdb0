package org.dfra.sim.world;

import java.time.Instant;
import java.util.List;
import org.dfra.sim.physics.RangeInput;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.MutableTransform;
import org.dfra.sim.world.shape.ObstacleIndex;
import org.dfra.sim.world.shape.RayCaster;

/**
 * Simulates a laser: obstacles, and other robots as rectangles, all at the time when its mirror's
 * rotation starts. Some beams have no echo: a few at random, and all from targets too far away for
 * their reflectivity. Ghosts occlude farther obstacles.
 */
final class SimulatedLaser implements RangeInput {

  /** Reflectivity of a robot. */
  private static final double ROBOT_REFLECTIVITY = 0.5;

  /** Reflectivity for which a laser's maximum range is specified. */
  private static final double TENTH = 0.1;

  /**
   * From this fraction of the maximum range on, beams begin to get lost; as far above it, all are
   * lost.
   */
  private static final double FADES = 0.8;

  private final World world;
  private final DeviceMount mount;
  private final RandomStream draws;
  private final GhostRangeModel ghosts;
  private final double white;
  private final double miss;
  private final double reach;
  private final RayCaster fan = new RayCaster(); // guarded by the world's monitor
  private final int[] near;

  SimulatedLaser(World world, DeviceMount mount, DeviceDescription device, RandomStream draws) {
    VehicleType type = mount.body().vehicle.type();
    this.world = world;
    this.mount = mount;
    this.draws = draws.substream("beams");
    this.white = device.parameter("white_noise_sigma", type);
    this.miss = device.parameter("dropout_probability", type);
    this.reach = device.parameter("range_at_10_percent", type);
    this.ghosts =
        new GhostRangeModel(
            draws.substream("ghosts"),
            device.parameter("ghost_rate", type),
            device.parameter("ghost_duration", type),
            device.parameter("ghost_width", type),
            device.parameter("ghost_min_range", type),
            device.parameter("ghost_max_range", type));
    this.near = new int[world.solids().size()];
  }

  @Override
  public void measure(Instant time, double first, double step, double longest, double[] distances) {
    if (!(longest > 0 && longest < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "the laser's range " + longest + " m is not finite and above 0");
    }
    synchronized (world.monitor()) {
      long now = world.stepAt(time);
      double[] row = world.row(now);
      MutableTransform transform = mount.at(row);
      fan.setBeams(first, step, distances.length);
      fan.beginScan(transform, longest);
      ObstacleIndex solids = world.solids();
      int count = solids.query(transform.east, transform.north, longest, near);
      for (int i = 0; i < count; i++) {
        fan.intersect(solids.solid(near[i]));
      }
      castRobots(row);
      long seed = draws.bits(now);
      for (int i = 0; i < distances.length; i++) {
        distances[i] = measured(i, seed);
      }
      ghosts.forEachAt(
          now * World.STEP_SECONDS,
          (bearing, halfWidth, distance) ->
              addGhost(first, step, bearing, halfWidth, distance, seed, distances));
      for (int i = 0; i < distances.length; i++) {
        distances[i] = distances[i] > longest ? Double.POSITIVE_INFINITY : distances[i];
      }
    }
  }

  private void castRobots(double[] row) {
    List<VehicleBody> bodies = world.bodies();
    for (int i = 0; i < bodies.size(); i++) {
      VehicleBody body = bodies.get(i);
      if (body != mount.body()) {
        int at = body.offset;
        double up = row[at + VehicleBody.UP];
        fan.intersect(body.boxAt(row), up, up + body.vehicle.height(), ROBOT_REFLECTIVITY);
      }
    }
  }

  private double measured(int beam, long seed) {
    double distance = fan.distance(beam);
    if (distance == Double.POSITIVE_INFINITY) {
      return distance;
    }
    double seen = reach * Math.sqrt(fan.reflectivity(beam) / TENTH);
    double fading = (distance / seen - FADES) / (2 * (1 - FADES));
    double lost = miss + (1 - miss) * Math.max(0, fading);
    return RandomStream.uniformOf(RandomStream.bits(seed, 2L * beam)) < lost
        ? Double.POSITIVE_INFINITY
        : noisy(distance, beam, seed);
  }

  private double noisy(double distance, int beam, long seed) {
    return Math.max(
        0, distance + white * RandomStream.gaussianOf(RandomStream.bits(seed, 2L * beam + 1)));
  }

  private void addGhost(
      double first,
      double step,
      double bearing,
      double halfWidth,
      double distance,
      long seed,
      double[] distances) {
    for (int i = 0; i < distances.length; i++) {
      double off = Math.IEEEremainder(first + i * step - bearing, 2 * Math.PI);
      if (Math.abs(off) <= halfWidth) {
        distances[i] = Math.min(distances[i], noisy(distance, i, seed));
      }
    }
  }
}
