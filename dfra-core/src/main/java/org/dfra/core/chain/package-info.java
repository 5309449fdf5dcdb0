/**
 * Chains: a module's inputs, which are found, subscribed to and rewired at run time, and the
 * periodic control loop that processes them. Start at {@link org.dfra.core.chain.ChainInputs}.
 */
@NullMarked
package org.dfra.core.chain;

import org.jspecify.annotations.NullMarked;
