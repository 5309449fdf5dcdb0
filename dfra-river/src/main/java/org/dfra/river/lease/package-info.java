/** Leases: for how long a client counts as one. Built on River's landlord. */
@NullMarked
package org.dfra.river.lease;

import org.jspecify.annotations.NullMarked;
