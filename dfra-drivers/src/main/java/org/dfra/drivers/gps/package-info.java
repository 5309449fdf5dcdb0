/**
 * Receivers of satellite positions: what their drivers have in common. Each protocol has a package
 * of its own below.
 *
 * <pre>
 *   bytes --&gt; GpsReceiverProtocol --solutions, satellites--&gt; GpsReceiverImpl --&gt; GPSSensor
 *             m12, nmea, ubx, gpsd                         the module
 *                    ^                                        |
 *                    +------ GpsLinkHandler &lt;-- LinkKeeper --+
 *                            is it alive?         opens, reads, opens again
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.GpsReceiverImpl}. A further receiver is one class that
 * extends it, with a parser of its own; nothing else in DFRA needs to know of it but a file of
 * module properties.
 */
@NullMarked
package org.dfra.drivers.gps;

import org.jspecify.annotations.NullMarked;
