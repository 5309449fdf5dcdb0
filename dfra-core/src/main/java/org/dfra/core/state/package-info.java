/**
 * What of a module outlives its virtual machine: its history, the numbers of its events. Enter at
 * {@link org.dfra.core.state.StateStore}.
 */
@NullMarked
package org.dfra.core.state;

import org.jspecify.annotations.NullMarked;
