/**
 * Receivers with NMEA 0183, lines of text that nearly all receivers support.
 *
 * <pre>
 *   bytes --&gt; NmeaFramer --&gt; NmeaDecoder --&gt; NmeaSentence --&gt; NmeaEpochAssembler --&gt; NmeaImpl
 *             finds sentences, pure,                           combines the
 *             counts the rest  never throws                    sentences of an epoch
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.nmea.NmeaImpl} for the driver, at {@link
 * org.dfra.drivers.gps.nmea.NmeaParser} for the protocol alone.
 *
 * <p>A sentence is {@code $} talker type {@code ,} fields {@code *} checksum, CR LF; the checksum
 * is the exclusive or of the characters between {@code $} and {@code *}, in hexadecimal. Fields may
 * be empty, and some receivers omit the checksum.
 */
@NullMarked
package org.dfra.drivers.gps.nmea;

import org.jspecify.annotations.NullMarked;
