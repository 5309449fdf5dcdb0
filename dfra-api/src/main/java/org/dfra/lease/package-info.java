/** Leases: they limit how long a client counts as a module's client without renewal. */
@NullMarked
package org.dfra.lease;

import org.jspecify.annotations.NullMarked;
