/**
 * The SICK LMS 200 and related laser scanners with SICK's telegrams of the LMS 2xx.
 *
 * <pre>
 *   bytes --&gt; LmsFramer --telegrams--&gt; LmsDecoder --&gt; LmsMessage --&gt; LmsProtocol --&gt; LmsImpl
 *             finds telegrams,         pure function,                one link,       the module:
 *             counts what it drops     never throws                  reader thread   any thread
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.laser.lms.LmsImpl} for the driver, at {@link
 * org.dfra.drivers.laser.lms.LmsParser} for the protocol alone.
 *
 * <p>A telegram is {@code 02 | address | length | payload | CRC}, numbers have their lowest byte
 * first, and the length counts the payload. The payload of a reply begins with the command + 80
 * (hex) and ends with a {@linkplain org.dfra.drivers.laser.lms.StatusByte status byte}; the laser's
 * address is 00, in replies 80. An ACK (06) precedes a reply; a NAK (15) replaces it. Source:
 * SICK's telegram listing of the LMS 2xx as open drivers have it, checked against one recorded
 * telegram; docs/reference/range-sensors.md lists what else was not checked.
 */
@NullMarked
package org.dfra.drivers.laser.lms;

import org.jspecify.annotations.NullMarked;
