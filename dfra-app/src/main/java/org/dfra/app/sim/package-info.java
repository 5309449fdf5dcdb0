/**
 * {@code ./dfra sim}: simulated worlds, whose devices the real drivers talk to.
 *
 * <p>Enter at {@link org.dfra.app.sim.SimCommand}.
 */
@NullMarked
package org.dfra.app.sim;

import org.jspecify.annotations.NullMarked;
