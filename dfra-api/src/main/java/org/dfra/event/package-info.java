/**
 * Events: how a module notifies its listeners, and how they limit what they receive.
 *
 * <pre>
 *   module --publishes--&gt; one queue per listener, bounded by its DeliveryPolicy --&gt; listener
 * </pre>
 *
 * <p>A listener that is slow, dead or suspended delays no other: its queue overflows, and the
 * number of lost events is counted and reported to it. Start at {@link
 * org.dfra.event.Subscription}.
 */
@NullMarked
package org.dfra.event;

import org.jspecify.annotations.NullMarked;
