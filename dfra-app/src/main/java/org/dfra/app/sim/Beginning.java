package org.dfra.app.sim;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import org.dfra.core.time.ScaledTime;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.run.SimulatedLine;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.world.description.WorldDescription;

/**
 * What {@code ./dfra sim run --json} tells first.
 *
 * @param world name of the world
 * @param seed what chance goes by
 * @param time what {@code DFRA_TIME} is to be for the robots
 * @param begin when the world began
 * @param datum where its east and north are 0
 * @param lines where the devices are
 */
public record Beginning(
    String world,
    long seed,
    String time,
    Instant begin,
    GeoPosition datum,
    List<SimulatedLine> lines) {

  static Beginning of(Simulation simulation, InstantSource clock) {
    WorldDescription world = simulation.world().description();
    return new Beginning(
        world.name(),
        world.seed(),
        clock instanceof ScaledTime scaled ? scaled.onThisComputer() : "real",
        simulation.world().start(),
        world.datum(),
        simulation.lines());
  }
}
