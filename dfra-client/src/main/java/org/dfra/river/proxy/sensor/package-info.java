/** Smart proxies of sensors. Enter at {@link org.dfra.river.proxy.sensor.SensorProxy}. */
@NullMarked
package org.dfra.river.proxy.sensor;

import org.jspecify.annotations.NullMarked;
