/**
 * An unmanned aerial vehicle that does not exist: its autopilot, byte by byte, in MAVLink 2.
 *
 * <pre>
 *   MulticopterPhysics  --where it truly is--&gt; Pilot --what it does--&gt; Telemetry --bytes--&gt; UartLine
 *   AntennaTrajectory --what GPS says------------------------------&gt;
 *   BatteryPhysics --what feeds it------------------------------&gt;
 *   bytes --&gt; MavlinkCommandReader --&gt; AutopilotDevice --orders--&gt; Pilot --moves--&gt; MulticopterPhysics
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.uav.AutopilotDevice}. Its frames are packed here, field by
 * field from the protocol's definition, with neither the driver's code nor its library. Source:
 * mavlink.io, common dialect; the behaviour of PX4 and of ArduCopter as their user guides have it,
 * much simplified.
 */
@NullMarked
package org.dfra.sim.device.uav;

import org.jspecify.annotations.NullMarked;
