/**
 * Message transport: {@link org.dfra.recruit.transport.Transport} is an agent's interface to it.
 * {@link org.dfra.recruit.transport.VirtualTime} replaces the clock in tests and simulations.
 */
@NullMarked
package org.dfra.recruit.transport;

import org.jspecify.annotations.NullMarked;
