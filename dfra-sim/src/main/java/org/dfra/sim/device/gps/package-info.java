/**
 * Emulated GPS receivers, at the byte level.
 *
 * <pre>
 *   AntennaTrajectory ---&gt; M12Device, NmeaDevice, UbxDevice, GpsdDevice ---&gt; UartLine
 *   antenna state          the receiver's protocol                          baud rate
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.gps.ReceiverEmulatorMain} for a receiver as a process of
 * its own. Nothing here uses a driver's code: encoder and decoder check each other.
 */
@NullMarked
package org.dfra.sim.device.gps;

import org.jspecify.annotations.NullMarked;
