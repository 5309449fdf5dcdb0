/**
 * Emulated network cameras, at the byte level. Enter at {@link
 * org.dfra.sim.device.camera.MjpegDevice}.
 */
@NullMarked
package org.dfra.sim.device.camera;

import org.jspecify.annotations.NullMarked;
