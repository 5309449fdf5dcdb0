/** Drivers of cameras, a package for each protocol: {@link org.dfra.drivers.camera.mjpeg}. */
@NullMarked
package org.dfra.drivers.camera;

import org.jspecify.annotations.NullMarked;
