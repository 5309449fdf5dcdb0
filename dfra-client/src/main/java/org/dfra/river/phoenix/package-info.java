/**
 * The part of the activation daemon that a client downloads: the identity of an activatable object,
 * by which a proxy has its server activated again. Enter at {@link
 * org.dfra.river.phoenix.JeriActivationID}. The daemon itself is in {@code dfra-phoenix} (decision
 * 051).
 */
@NullMarked
package org.dfra.river.phoenix;

import org.jspecify.annotations.NullMarked;
