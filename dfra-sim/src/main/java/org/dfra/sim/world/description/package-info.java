/**
 * What a world is made of, as it is written down: ground, weather, obstacles, mines, robots and
 * their devices with what is wrong with them.
 *
 * <p>Enter at {@link org.dfra.sim.world.description.WorldDescription}. All of it is records that
 * check themselves, or are checked when they become part of a world; {@code
 * org.dfra.sim.world.file} reads and writes them. Lengths are metres, angles radians, temperatures
 * kelvin; the world's frame is ENU with its origin at the datum.
 */
@NullMarked
package org.dfra.sim.world.description;

import org.jspecify.annotations.NullMarked;
