/**
 * u-blox receivers with the binary protocol UBX.
 *
 * <pre>
 *   bytes --&gt; UbxFramer --&gt; UbxDecoder --&gt; UbxMessage --&gt; UbxImpl
 *             finds frames, pure,
 *             counts the rest never throws
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.ubx.UbxImpl} for the driver, at {@link
 * org.dfra.drivers.gps.ubx.UbxParser} for the protocol alone.
 *
 * <p>A frame is {@code B5 62} class ID, length (two bytes), payload, checksum (two bytes,
 * Fletcher's, of class to payload); numbers have their lowest byte first. Source: u-blox receiver
 * descriptions, protocol versions 14 to 27.
 */
@NullMarked
package org.dfra.drivers.gps.ubx;

import org.jspecify.annotations.NullMarked;
