/**
 * Emulated pan-tilt units, at the byte level. Enter at {@link
 * org.dfra.sim.device.pantilt.PtuDevice}.
 */
@NullMarked
package org.dfra.sim.device.pantilt;

import org.jspecify.annotations.NullMarked;
