/** What clients may call on behaviours over the network. */
@NullMarked
package org.dfra.river.remote.behavior;

import org.jspecify.annotations.NullMarked;
