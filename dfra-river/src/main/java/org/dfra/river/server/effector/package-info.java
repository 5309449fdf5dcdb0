/**
 * Servers of effectors. Enter at {@link org.dfra.river.server.effector.EffectorServer}, which
 * grants command leases to remote clients.
 */
@NullMarked
package org.dfra.river.server.effector;

import org.jspecify.annotations.NullMarked;
