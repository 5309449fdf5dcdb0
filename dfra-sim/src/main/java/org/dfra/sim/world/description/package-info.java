/**
 * Descriptions of a world: ground, weather, obstacles, mines, robots, and their devices with their
 * errors.
 *
 * <p>Enter at {@link org.dfra.sim.world.description.WorldDescription}. All types are records that
 * validate themselves, or are validated when they become part of a world; {@code
 * org.dfra.sim.world.file} reads and writes them. Lengths are metres, angles radians, temperatures
 * kelvin; the world's frame is ENU with its origin at the datum.
 */
@NullMarked
package org.dfra.sim.world.description;

import org.jspecify.annotations.NullMarked;
