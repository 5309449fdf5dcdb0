/**
 * Network cameras that do not exist, byte by byte. Enter at {@link
 * org.dfra.sim.device.camera.MjpegDevice}.
 */
@NullMarked
package org.dfra.sim.device.camera;

import org.jspecify.annotations.NullMarked;
