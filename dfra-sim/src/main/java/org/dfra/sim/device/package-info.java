/**
 * Emulated devices, at the byte level: each uses its device's own protocol, so that a simulated
 * robot runs the real driver.
 *
 * <pre>
 *   AntennaTrajectory ---&gt; SerialDevice ----&gt; UartLine ---&gt; DeviceEmulator &lt;==tcp==&gt; a driver
 *   antenna state          M12Device, ...     baud rate '-&gt; SimPort        &lt;==sim==&gt; a driver
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.DeviceEmulator} for a device behind a TCP port, at {@link
 * org.dfra.sim.device.SimPort} for one in lock-step with its driver, at {@link
 * org.dfra.sim.device.ReceiverEmulatorMain} for a receiver as a process of its own. A {@link
 * org.dfra.sim.device.SerialDevice} is the protocol alone and has no thread: it can be stepped
 * together with a clock.
 *
 * <p>Nothing here uses a driver's code: encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device;

import org.jspecify.annotations.NullMarked;
