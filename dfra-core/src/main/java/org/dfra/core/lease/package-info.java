/**
 * Leases inside one virtual machine: they define a module's clients, and until when. Start at
 * {@link org.dfra.core.lease.LeaseRegistry}; the distributed layer's landlord uses the same
 * registry.
 */
@NullMarked
package org.dfra.core.lease;

import org.jspecify.annotations.NullMarked;
