/** Servers of sensors. Enter at {@link org.dfra.river.server.sensor.SensorServer}. */
@NullMarked
package org.dfra.river.server.sensor;

import org.jspecify.annotations.NullMarked;
