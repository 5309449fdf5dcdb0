/**
 * {@code ./dfra sim}: simulated worlds with devices for the real drivers.
 *
 * <p>Entry point: {@link org.dfra.examples.sim.SimCommand}.
 */
@NullMarked
package org.dfra.examples.sim;

import org.jspecify.annotations.NullMarked;
