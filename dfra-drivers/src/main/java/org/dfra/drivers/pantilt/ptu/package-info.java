/**
 * The pan-tilt units of Directed Perception, PTU-46 and D46, by their commands in ASCII.
 *
 * <pre>
 *   bytes --&gt; PtuFramer --lines--&gt; PtuDecoder --PtuReply--&gt; PtuDialogue --whose reply it is--&gt;
 *   PtuProtocol --where the head points--&gt; PtuImpl
 *   PtuImpl, PtuProtocol --commands--&gt; PtuDialogue --bytes--&gt; the unit
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.pantilt.ptu.PtuImpl}. Source: Directed Perception, PTU-D46
 * User's Manual 2.14.0, section 4.
 */
@NullMarked
package org.dfra.drivers.pantilt.ptu;

import org.jspecify.annotations.NullMarked;
