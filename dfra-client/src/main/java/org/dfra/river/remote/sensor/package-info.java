/** What clients may call on sensors over the network. */
@NullMarked
package org.dfra.river.remote.sensor;

import org.jspecify.annotations.NullMarked;
