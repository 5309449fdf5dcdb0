/**
 * Events inside one virtual machine.
 *
 * <pre>
 *   ModuleImpl --publish--&gt; EventHub --&gt; ListenerQueue --DeliveryPool--&gt; listener
 *                               \------&gt; ListenerQueue --DeliveryPool--&gt; listener that blocks
 * </pre>
 *
 * <p>Enter at {@link org.dfra.core.event.EventHub}. A remote listener is a listener like any other
 * here; the distributed layer uses {@link org.dfra.core.event.ListenerQueue} once more on the
 * listener's side, so that a slow listener does not hold the call that tells it.
 */
@NullMarked
package org.dfra.core.event;

import org.jspecify.annotations.NullMarked;
