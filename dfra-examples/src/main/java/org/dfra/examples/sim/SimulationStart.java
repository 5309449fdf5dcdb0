package org.dfra.examples.sim;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import org.dfra.core.time.ScaledTime;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.run.Simulation.DeviceEndpoint;
import org.dfra.sim.world.description.WorldDescription;

/**
 * The first output of {@code ./dfra sim run --json}.
 *
 * @param world name of the world
 * @param seed random seed
 * @param dfraTime value of {@code DFRA_TIME} for the robots
 * @param startTime when the world began
 * @param datum where its east and north are 0
 * @param endpoints of the devices
 */
public record SimulationStart(
    String world,
    long seed,
    String dfraTime,
    Instant startTime,
    GeoPosition datum,
    List<DeviceEndpoint> endpoints) {

  static SimulationStart of(Simulation simulation, InstantSource clock) {
    WorldDescription world = simulation.world().description();
    return new SimulationStart(
        world.name(),
        world.seed(),
        clock instanceof ScaledTime scaled ? scaled.toHostText() : "real",
        simulation.world().start(),
        world.datum(),
        simulation.endpoints());
  }
}
