/**
 * Message transport: {@link org.dfra.recruit.transport.Transport} is an agent's interface to it.
 * {@link org.dfra.recruit.transport.SimulatedNetwork} loses, delays and counts messages, and uses
 * {@link org.dfra.recruit.transport.VirtualTime}.
 */
@NullMarked
package org.dfra.recruit.transport;

import org.jspecify.annotations.NullMarked;
