package org.dfra.sim.world;

import org.dfra.sim.world.description.WeatherDescription;
import org.dfra.sim.world.noise.RandomStream;

/**
 * What a body needs of its world while it is made.
 *
 * @param random all chance in the world
 */
record BodyContext(
    StateLayout layout,
    Terrain terrain,
    CollisionDetector collisions,
    WeatherDescription weather,
    RandomStream random) {}
