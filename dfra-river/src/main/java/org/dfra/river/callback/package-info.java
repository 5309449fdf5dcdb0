/**
 * Callbacks to objects of clients, such as listeners, with limits on the resources that each client
 * uses of this process.
 *
 * <pre>
 *   registration --admit--&gt; CallbackLimiter --&gt; CallbackSlot: executor of the delivery pool
 *                              | PeerQuota: limits the processes of each client address
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.callback.CallbackLimiter}. Modules use it for their remote
 * listeners, a robot's lookup service for its event listeners.
 */
@NullMarked
package org.dfra.river.callback;

import org.jspecify.annotations.NullMarked;
