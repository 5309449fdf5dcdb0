/**
 * Calls back objects of clients, such as listeners, so that no client can hold more of this process
 * than its share.
 *
 * <pre>
 *   registration --admit--&gt; CallbackLimiter --&gt; CallbackSlot: a lane of the delivery pool
 *                              | PeerQuota: processes of each client address
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.callback.CallbackLimiter}. Modules use it for their remote
 * listeners, a robot's lookup service for its event listeners.
 */
@NullMarked
package org.dfra.river.callback;

import org.jspecify.annotations.NullMarked;
