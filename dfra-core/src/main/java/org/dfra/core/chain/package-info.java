/**
 * What makes a chain flow: a module's inputs, found, listened to and wired anew while it runs, and
 * the loop that acts on them at a rate. Enter at {@link org.dfra.core.chain.ChainInputs}.
 */
@NullMarked
package org.dfra.core.chain;

import org.jspecify.annotations.NullMarked;
