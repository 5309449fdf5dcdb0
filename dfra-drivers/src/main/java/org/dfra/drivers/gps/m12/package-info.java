/**
 * The Motorola Oncore M12+ and related GPS receivers with Motorola's binary protocol.
 *
 * <pre>
 *   bytes --&gt; M12Framer --frames--&gt; M12Decoder --&gt; M12Message --&gt; M12Protocol --&gt; M12PlusImpl
 *             finds frames,         pure function,                one link,       the module:
 *             counts what it drops  never throws                  reader thread   any thread
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.m12.M12PlusImpl} for the driver, at {@link
 * org.dfra.drivers.gps.m12.M12Parser} for the protocol alone. To support a further message, add a
 * record to {@link org.dfra.drivers.gps.m12.M12Message} and a case to {@link
 * org.dfra.drivers.gps.m12.M12Decoder}; until then it arrives as an {@link
 * org.dfra.drivers.gps.m12.M12Message.OtherMessage}.
 *
 * <p>A frame is {@code @@ ID1 ID2 payload C CR LF}: ID1 is A-Z, ID2 is A-Z or a-z, C is the
 * exclusive or of every byte from ID1 to the last of the payload, numbers have their highest byte
 * first, and the length is fixed by the ID. Source: Motorola Oncore M12+ user's guide, checked
 * against recordings of two receivers.
 */
@NullMarked
package org.dfra.drivers.gps.m12;

import org.jspecify.annotations.NullMarked;
