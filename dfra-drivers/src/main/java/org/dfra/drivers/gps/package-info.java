/**
 * Satellite positioning receivers: the common base of their drivers. Each protocol has a
 * subpackage.
 *
 * <pre>
 *   bytes --&gt; GpsReceiverProtocol --solutions, satellites--&gt; GpsReceiverImpl --&gt; GPSSensor
 *             m12, nmea, ubx, gpsd                         the module
 *                    ^                                        |
 *                    +------ GpsLinkHandler &lt;-- LinkKeeper ---+
 *                            is it alive?         opens, reads, reopens
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.GpsReceiverImpl}. The driver of a further receiver
 * extends it and has its own parser; apart from a file of module properties, nothing else in DFRA
 * changes.
 */
@NullMarked
package org.dfra.drivers.gps;

import org.jspecify.annotations.NullMarked;
