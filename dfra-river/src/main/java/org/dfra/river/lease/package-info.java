/** Leases: how long a module counts a client. Built on River's landlord. */
@NullMarked
package org.dfra.river.lease;

import org.jspecify.annotations.NullMarked;
