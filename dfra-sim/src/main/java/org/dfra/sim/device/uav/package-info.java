/**
 * An emulated unmanned aerial vehicle: its autopilot, at the byte level, in MAVLink 2.
 *
 * <pre>
 *   MulticopterPhysics --true pose--&gt; AutopilotStateMachine --state--&gt; Telemetry
 *   AntennaTrajectory --GPS data-------------------------------------&gt; Telemetry
 *   BatteryPhysics --voltage, current--------------------------------&gt; Telemetry --bytes--&gt; UartLine
 *   bytes --&gt; MavlinkCommandReader --&gt; AutopilotDevice --commands--&gt; AutopilotStateMachine
 *                    AutopilotStateMachine --targets--&gt; MulticopterPhysics
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.device.uav.AutopilotDevice}. It encodes its frames field by field
 * from the protocol's definition, without the driver's code or library. Source: mavlink.io, common
 * dialect; the behaviour of PX4 and of ArduCopter follows their user guides, much simplified.
 */
@NullMarked
package org.dfra.sim.device.uav;

import org.jspecify.annotations.NullMarked;
