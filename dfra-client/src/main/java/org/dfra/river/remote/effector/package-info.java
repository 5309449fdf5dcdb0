/** What clients may call on effectors over the network. */
@NullMarked
package org.dfra.river.remote.effector;

import org.jspecify.annotations.NullMarked;
