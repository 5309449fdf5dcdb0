/**
 * Receivers behind gpsd, the daemon of most Linux systems that speaks with receivers of all makers.
 *
 * <pre>
 *   bytes --&gt; GpsdFramer --&gt; GpsdDecoder --&gt; GpsdMessage --&gt; GpsdImpl
 *             finds objects, pure,
 *             counts the rest never throws
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.gpsd.GpsdImpl} for the driver, at {@link
 * org.dfra.drivers.gps.gpsd.GpsdParser} for the bytes alone.
 *
 * <p>Over TCP, port 2947 by default, come lines of JSON, one object in each, whose first member is
 * {@code class}. Source: gpsd's protocol documentation, versions 3.20 to 3.25.
 */
@NullMarked
package org.dfra.drivers.gps.gpsd;

import org.jspecify.annotations.NullMarked;
