/** Servers of behaviours. Enter at {@link org.dfra.river.server.behavior.BehaviorServer}. */
@NullMarked
package org.dfra.river.server.behavior;

import org.jspecify.annotations.NullMarked;
