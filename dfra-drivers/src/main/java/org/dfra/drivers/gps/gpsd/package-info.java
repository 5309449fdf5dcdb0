/**
 * Receivers behind gpsd, a daemon on Linux that supports receivers of many manufacturers.
 *
 * <pre>
 *   bytes --&gt; GpsdFramer --&gt; GpsdDecoder --&gt; GpsdMessage --&gt; GpsdImpl
 *             finds objects, pure,
 *             counts the rest never throws
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.gpsd.GpsdImpl} for the driver, at {@link
 * org.dfra.drivers.gps.gpsd.GpsdParser} for the protocol alone.
 *
 * <p>gpsd sends lines of JSON over TCP, port 2947 by default; each line is one object whose first
 * member is {@code class}. Source: gpsd's protocol documentation, versions 3.20 to 3.25.
 */
@NullMarked
package org.dfra.drivers.gps.gpsd;

import org.jspecify.annotations.NullMarked;
