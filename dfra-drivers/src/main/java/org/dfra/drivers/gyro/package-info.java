/** Drivers of rate gyros, a package for each protocol: {@link org.dfra.drivers.gyro.kvh}. */
@NullMarked
package org.dfra.drivers.gyro;

import org.jspecify.annotations.NullMarked;
