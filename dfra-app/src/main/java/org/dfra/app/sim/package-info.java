/**
 * {@code ./dfra sim}: simulated worlds with devices for the real drivers.
 *
 * <p>Entry point: {@link org.dfra.app.sim.SimCommand}.
 */
@NullMarked
package org.dfra.app.sim;

import org.jspecify.annotations.NullMarked;
