/**
 * Devices that do not exist, byte by byte: each speaks its device's own protocol, so that the real
 * driver is what a simulated robot runs.
 *
 * <pre>
 *   AntennaTrajectory ---&gt; SerialDevice ---&gt; UartLine ---&gt; DeviceEmulator &lt;==tcp==&gt; a driver
 *   where it is      what it says      how fast  '-&gt; SimPort        &lt;==sim==&gt; a driver
 *                    M12Device, NmeaDevice, ...       over what
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.DeviceEmulator} for a device behind a TCP port, at {@link
 * org.dfra.sim.device.SimPort} for one in lock-step with its driver, at {@link
 * org.dfra.sim.device.ReceiverEmulatorMain} for a receiver as a process. A {@link
 * org.dfra.sim.device.SerialDevice} is the protocol alone and knows no thread: it can be stepped
 * together with a clock.
 *
 * <p>Nothing here uses a driver's code: encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device;

import org.jspecify.annotations.NullMarked;
