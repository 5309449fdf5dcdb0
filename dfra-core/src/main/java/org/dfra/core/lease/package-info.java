/**
 * Leases inside one virtual machine: who counts as a module's client, and until when. Enter at
 * {@link org.dfra.core.lease.LeaseRegistry}; the distributed layer's landlord writes into the same
 * book.
 */
@NullMarked
package org.dfra.core.lease;

import org.jspecify.annotations.NullMarked;
