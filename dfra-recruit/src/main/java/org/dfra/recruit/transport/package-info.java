/**
 * How letters travel: {@link org.dfra.recruit.transport.Transport} is what an agent sees of it.
 * {@link org.dfra.recruit.transport.SimulatedNetwork} loses and delays them, counts them, and lives
 * by {@link org.dfra.recruit.transport.VirtualTime}.
 */
@NullMarked
package org.dfra.recruit.transport;

import org.jspecify.annotations.NullMarked;
