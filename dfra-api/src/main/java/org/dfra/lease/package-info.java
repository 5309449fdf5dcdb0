/**
 * Leases: for how long somebody counts as a module's client, at the most, without saying so again.
 */
@NullMarked
package org.dfra.lease;

import org.jspecify.annotations.NullMarked;
