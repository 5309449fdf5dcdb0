/**
 * What of a module outlives its virtual machine: its history, the numbers of its events, whether it
 * is stopped for an emergency. Enter at {@link org.dfra.core.state.StateStore}.
 */
@NullMarked
package org.dfra.core.state;

import org.jspecify.annotations.NullMarked;
