/**
 * Events: how a module tells those who listen, and how they say what they can take.
 *
 * <pre>
 *   module --publishes--&gt; one queue per listener, bounded by its DeliveryPolicy --&gt; listener
 * </pre>
 *
 * <p>A listener that is slow, dead or stopped delays nobody: its queue overflows, what it lost is
 * counted, and it is told. Enter at {@link org.dfra.event.Subscription}.
 */
@NullMarked
package org.dfra.event;

import org.jspecify.annotations.NullMarked;
