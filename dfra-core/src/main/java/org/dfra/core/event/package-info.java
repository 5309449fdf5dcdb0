/**
 * Events inside one virtual machine.
 *
 * <pre>
 *   ModuleImpl --publish--&gt; EventHub --&gt; ListenerQueue --DeliveryPool--&gt; listener
 *                               \------&gt; ListenerQueue --DeliveryPool--&gt; listener that blocks
 * </pre>
 *
 * <p>Enter at {@link org.dfra.core.event.EventHub}. A remote listener is a listener like any other
 * here. The queues are those of {@link org.dfra.event.delivery}.
 */
@NullMarked
package org.dfra.core.event;

import org.jspecify.annotations.NullMarked;
