/**
 * Pan-tilt units that do not exist, byte by byte. Enter at {@link
 * org.dfra.sim.device.pantilt.PtuDevice}.
 */
@NullMarked
package org.dfra.sim.device.pantilt;

import org.jspecify.annotations.NullMarked;
