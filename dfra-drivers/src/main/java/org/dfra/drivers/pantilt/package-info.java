/** Drivers of pan-tilt units, a package for each protocol: {@link org.dfra.drivers.pantilt.ptu}. */
@NullMarked
package org.dfra.drivers.pantilt;

import org.jspecify.annotations.NullMarked;
