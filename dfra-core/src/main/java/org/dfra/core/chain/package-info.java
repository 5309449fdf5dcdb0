/**
 * What makes a chain flow: a module's inputs, listened to and wired anew while it runs. Enter at
 * {@link org.dfra.core.chain.ChainInputs}.
 */
@NullMarked
package org.dfra.core.chain;

import org.jspecify.annotations.NullMarked;
