/**
 * Servers of effectors. Enter at {@link org.dfra.river.server.effector.EffectorServer}, which
 * grants command leases to clients elsewhere.
 */
@NullMarked
package org.dfra.river.server.effector;

import org.jspecify.annotations.NullMarked;
