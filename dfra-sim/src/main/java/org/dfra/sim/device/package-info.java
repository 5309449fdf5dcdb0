/**
 * Devices that do not exist, byte by byte: each speaks its device's own protocol, so that the real
 * driver is what a simulated robot runs.
 *
 * <pre>
 *   AntennaPath ---&gt; M12Device ---&gt; UartLine ---&gt; M12Emulator &lt;==tcp==&gt; a driver
 *   where it is      what it says   how fast       over what
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.M12Emulator} for a receiver behind a TCP port, at {@link
 * org.dfra.sim.device.M12EmulatorMain} for one as a process. {@link org.dfra.sim.device.M12Device}
 * is the protocol alone and knows no thread: it can be stepped together with a clock.
 *
 * <p>Nothing here uses a driver's code: encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device;

import org.jspecify.annotations.NullMarked;
