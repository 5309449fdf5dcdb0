/**
 * Events inside one virtual machine.
 *
 * <pre>
 *   ModuleImpl --publish--&gt; EventHub --&gt; ListenerQueue --DeliveryPool--&gt; listener
 *                               \------&gt; ListenerQueue --DeliveryPool--&gt; listener that blocks
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.event.EventHub}. Remote listeners are treated like local ones
 * here. The queues are those of {@link org.dfra.event.delivery}.
 */
@NullMarked
package org.dfra.core.event;

import org.jspecify.annotations.NullMarked;
