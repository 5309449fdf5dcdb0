/**
 * Unmanned aerial vehicles over MAVLink 2: a flight controller, and the satellite receiver and the
 * battery behind it.
 *
 * <pre>
 *   bytes --&gt; MavlinkFramer --&gt; MavlinkDecoder --&gt; MavlinkMessage
 *             finds frames,     pure,              |
 *             counts the rest   never throws       v
 *                                          MavlinkConnection --&gt; MavlinkFlightImpl
 *             one for each link,           |                 --&gt; MavlinkGpsImpl
 *             shared by the modules        |                 --&gt; MavlinkBatteryImpl
 *   bytes &lt;-- MavlinkEncoder &lt;-- CommandProtocol &lt;-- FlightCommandSequencer
 *                                resends until        one command after
 *                                acknowledged         the other
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.uav.mavlink.MavlinkFlightImpl} for the driver, at {@link
 * org.dfra.drivers.uav.mavlink.MavlinkParser} for the protocol alone.
 *
 * <p>A frame is {@code FD}, length, incompatible flags, compatible flags, sequence, system,
 * component, message (three bytes), payload, checksum (two bytes, CRC-16/MCRF4XX of everything
 * after {@code FD} and of one byte that represents the message's definition); numbers have their
 * lowest byte first, and zero bytes at the payload's end are omitted. Source: mavlink.io,
 * "Serialization" and "Command Protocol".
 */
@NullMarked
package org.dfra.drivers.uav.mavlink;

import org.jspecify.annotations.NullMarked;
