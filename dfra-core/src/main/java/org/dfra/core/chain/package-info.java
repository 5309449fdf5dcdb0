/**
 * Chains: a module's inputs, which are found, subscribed to and rewired at run time. Start at
 * {@link org.dfra.core.chain.ChainInputs}.
 */
@NullMarked
package org.dfra.core.chain;

import org.jspecify.annotations.NullMarked;
