/**
 * Emulated devices, at the byte level: each uses its device's own protocol, so that a simulated
 * robot runs the real driver.
 *
 * <pre>
 *   a device's input ---&gt; SerialDevice ----&gt; UartLine ---&gt; DeviceEmulator &lt;==tcp==&gt; a driver
 *                         M12Device, ...     baud rate '-&gt; SimPort        &lt;==sim==&gt; a driver
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.DeviceEmulator} for a device behind a TCP port, at {@link
 * org.dfra.sim.device.SimPort} for one in lock-step with its driver. A {@link
 * org.dfra.sim.device.SerialDevice} is the protocol alone and has no thread: it can be stepped
 * together with a clock. The devices are in the packages below: {@code camera}, {@code drive},
 * {@code gps}, {@code gyro}, {@code laser}, {@code pantilt} and {@code uav}.
 *
 * <p>Nothing here uses a driver's code: encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device;

import org.jspecify.annotations.NullMarked;
