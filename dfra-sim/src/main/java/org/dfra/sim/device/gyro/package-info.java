/**
 * Emulated rate gyros, at the byte level. Enter at {@link org.dfra.sim.device.gyro.Dsp3000Device}.
 */
@NullMarked
package org.dfra.sim.device.gyro;

import org.jspecify.annotations.NullMarked;
