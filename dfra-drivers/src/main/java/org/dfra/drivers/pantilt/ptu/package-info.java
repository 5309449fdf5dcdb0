/**
 * The pan-tilt units of Directed Perception, PTU-46 and D46, with their ASCII commands.
 *
 * <pre>
 *   bytes --&gt; PtuFramer --lines--&gt; PtuDecoder --PtuReply--&gt; PtuExchange --matched replies--&gt;
 *   PtuProtocol --positions--&gt; PtuImpl
 *   PtuImpl, PtuProtocol --commands--&gt; PtuExchange --bytes--&gt; the unit
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.pantilt.ptu.PtuImpl}. Source: Directed Perception, PTU-D46
 * User's Manual 2.14.0, section 4.
 */
@NullMarked
package org.dfra.drivers.pantilt.ptu;

import org.jspecify.annotations.NullMarked;
