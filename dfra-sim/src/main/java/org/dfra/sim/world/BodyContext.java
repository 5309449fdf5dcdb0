package org.dfra.sim.world;

import org.dfra.sim.world.description.WeatherDescription;
import org.dfra.sim.world.noise.RandomStream;

/**
 * The parts of the world that a body's constructor needs.
 *
 * @param random source of all random numbers in the world
 */
record BodyContext(
    StateLayout layout,
    Terrain terrain,
    CollisionDetector collisions,
    WeatherDescription weather,
    RandomStream random) {}
