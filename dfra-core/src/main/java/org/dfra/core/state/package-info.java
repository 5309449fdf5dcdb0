/**
 * The persistent state of a module: its history, the sequence numbers of its events, its
 * emergency-stop state. Start at {@link org.dfra.core.state.StateStore}.
 */
@NullMarked
package org.dfra.core.state;

import org.jspecify.annotations.NullMarked;
