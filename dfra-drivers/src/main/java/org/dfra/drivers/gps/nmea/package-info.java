/**
 * Receivers that speak NMEA 0183, which nearly all do: lines of text.
 *
 * <pre>
 *   bytes --&gt; NmeaFramer --&gt; NmeaDecoder --&gt; NmeaSentence --&gt; NmeaEpochAssembler --&gt; NmeaImpl
 *             finds sentences, pure,                           puts the sentences
 *             counts the rest  never throws                    of a moment together
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.gps.nmea.NmeaImpl} for the driver, at {@link
 * org.dfra.drivers.gps.nmea.NmeaParser} for the bytes alone.
 *
 * <p>A sentence is {@code $} talker type {@code ,} fields {@code *} checksum, CR LF; the checksum
 * is the exclusive or of what stands between {@code $} and {@code *}, in hexadecimal. Fields may be
 * empty, and some receivers leave the checksum out.
 */
@NullMarked
package org.dfra.drivers.gps.nmea;

import org.jspecify.annotations.NullMarked;
