/**
 * How deliveries reach a listener without holding up anybody else.
 *
 * <pre>
 *   module --offer--&gt; ListenerQueue --DeliveryPool--&gt; listener
 * </pre>
 *
 * <p>Enter at {@link org.dfra.event.delivery.ListenerQueue}: what waits for one listener, bounded
 * by its policy. Both ends of a subscription have one: the module's, so that a slow listener does
 * not hold up the device, and a remote listener's, so that it does not hold the call that tells it.
 * Listeners elsewhere share the pool by {@link org.dfra.event.delivery.PeerExecutors}. {@link
 * org.dfra.event.delivery.DeliveryCounter} counts what was lost between the two. Needs the JDK
 * only, since clients download it.
 */
@NullMarked
package org.dfra.event.delivery;

import org.jspecify.annotations.NullMarked;
