/**
 * Rate gyros that do not exist, byte by byte. Enter at {@link
 * org.dfra.sim.device.gyro.Dsp3000Device}.
 */
@NullMarked
package org.dfra.sim.device.gyro;

import org.jspecify.annotations.NullMarked;
