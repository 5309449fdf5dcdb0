/**
 * Delivers events to a listener without delaying others.
 *
 * <pre>
 *   module --offer--&gt; ListenerQueue --DeliveryPool--&gt; listener
 * </pre>
 *
 * <p>Start at {@link org.dfra.event.delivery.ListenerQueue}: the queue of one listener, bounded by
 * its policy. Both ends of a subscription have one: the module's, so that a slow listener does not
 * delay the device, and the remote listener's, so that it does not delay the call that notifies it.
 * Remote listeners share the pool through {@link org.dfra.event.delivery.PeerExecutors}. {@link
 * org.dfra.event.delivery.DeliveryCounter} counts the events lost between the two. Needs the JDK
 * only, since clients download it.
 */
@NullMarked
package org.dfra.event.delivery;

import org.jspecify.annotations.NullMarked;
