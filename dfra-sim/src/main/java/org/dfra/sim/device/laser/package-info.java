/**
 * Emulated lasers, at the byte level.
 *
 * <pre>
 *   RangeInput ---&gt; LmsDevice ---&gt; UartLine ---&gt; DeviceEmulator &lt;==tcp==&gt; a driver
 *   ranges          telegrams      baud rate     transport
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.laser.LmsDevice}. Nothing here uses a driver's code:
 * encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device.laser;

import org.jspecify.annotations.NullMarked;
