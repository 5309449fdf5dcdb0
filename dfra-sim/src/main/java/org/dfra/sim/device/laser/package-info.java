/**
 * Lasers that do not exist, byte by byte.
 *
 * <pre>
 *   RangeInput ---&gt; LmsDevice ---&gt; UartLine ---&gt; DeviceEmulator &lt;==tcp==&gt; a driver
 *   what it sees   telegrams      how fast      over what
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.laser.LmsDevice}. Nothing here uses a driver's code:
 * encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device.laser;

import org.jspecify.annotations.NullMarked;
