package org.dfra.sim.world;

import java.time.Instant;
import java.util.List;
import org.dfra.sim.body.RangeView;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.VehicleType;
import org.dfra.sim.world.noise.Draws;
import org.dfra.sim.world.shape.BeamFan;
import org.dfra.sim.world.shape.SolidGrid;
import org.dfra.sim.world.shape.Stance;

/**
 * What a laser sees: solids, and other robots as rectangles, all at the moment when its mirror
 * begins to turn. Some beams do not come back: a few anywhere, and all from what is too far away
 * for the light it returns. Ghosts hide what is behind them.
 */
final class LaserView implements RangeView {

  /** Part of a laser's light that a robot returns. */
  private static final double ROBOT_REFLECTIVITY = 0.5;

  /** What a laser's reach is told for. */
  private static final double TENTH = 0.1;

  /** From this part of the reach on beams begin to get lost, and as far above it all are. */
  private static final double FADES = 0.8;

  private final World world;
  private final Rig rig;
  private final Draws draws;
  private final Ghosts ghosts;
  private final double white;
  private final double miss;
  private final double reach;
  private final BeamFan fan = new BeamFan(); // guarded by the world's monitor
  private final int[] near;

  LaserView(World world, Rig rig, DeviceDescription device, Draws draws) {
    VehicleType type = rig.body().vehicle.type();
    this.world = world;
    this.rig = rig;
    this.draws = draws.of("beams");
    this.white = device.parameter("white", type);
    this.miss = device.parameter("miss", type);
    this.reach = device.parameter("reach", type);
    this.ghosts =
        new Ghosts(
            draws.of("ghosts"),
            device.parameter("ghosts", type),
            device.parameter("ghost_time", type),
            device.parameter("ghost_width", type),
            device.parameter("ghost_near", type),
            device.parameter("ghost_far", type));
    this.near = new int[world.solids().size()];
  }

  @Override
  public void look(Instant time, double first, double step, double longest, double[] distances) {
    if (!(longest > 0 && longest < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("a laser that sees " + longest + " m far sees nothing");
    }
    synchronized (world.monitor()) {
      long now = world.stepAt(time);
      double[] row = world.row(now);
      Stance stance = rig.at(row);
      fan.shape(first, step, distances.length);
      fan.begin(stance, longest);
      SolidGrid solids = world.solids();
      int count = solids.near(stance.east, stance.north, longest, near);
      for (int i = 0; i < count; i++) {
        fan.see(solids.solid(near[i]));
      }
      seeOthers(row);
      long seed = draws.bits(now);
      for (int i = 0; i < distances.length; i++) {
        distances[i] = measured(i, seed);
      }
      ghosts.at(
          now * World.STEP_SECONDS,
          (bearing, halfWidth, distance) ->
              haunt(first, step, bearing, halfWidth, distance, seed, distances));
      for (int i = 0; i < distances.length; i++) {
        distances[i] = distances[i] > longest ? Double.POSITIVE_INFINITY : distances[i];
      }
    }
  }

  private void seeOthers(double[] row) {
    List<Body> bodies = world.bodies();
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      if (body != rig.body()) {
        int at = body.offset;
        double up = row[at + Body.UP];
        fan.see(body.boxAt(row), up, up + body.vehicle.height(), ROBOT_REFLECTIVITY);
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
    return Draws.uniformOf(Draws.bits(seed, 2L * beam)) < lost
        ? Double.POSITIVE_INFINITY
        : noisy(distance, beam, seed);
  }

  private double noisy(double distance, int beam, long seed) {
    return Math.max(0, distance + white * Draws.gaussianOf(Draws.bits(seed, 2L * beam + 1)));
  }

  private void haunt(
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
