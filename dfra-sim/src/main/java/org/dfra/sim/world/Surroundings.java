package org.dfra.sim.world;

import org.dfra.sim.world.description.WeatherDescription;
import org.dfra.sim.world.noise.Draws;

/**
 * What a body needs of its world while it is made.
 *
 * @param draws all chance in the world
 */
record Surroundings(
    Slots slots, Terrain terrain, Contacts contacts, WeatherDescription weather, Draws draws) {}
