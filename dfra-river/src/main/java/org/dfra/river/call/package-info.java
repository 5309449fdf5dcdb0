/**
 * How a remote call leaves this machine and what becomes of it.
 *
 * <pre>
 *   caller --&gt; ResurrectingHandler --&gt; DeadlineInvocationHandler --&gt; JERI --&gt; server
 *                 | server dead            | no answer in time
 *                 v                        v
 *              activator              DeadlineExceededException
 * </pre>
 *
 * <p>A server chooses both by its exporter: {@link org.dfra.river.call.DeadlineILFactory} gives
 * every call on the exported object a deadline, {@link org.dfra.river.call.ResurrectingExporter}
 * makes the proxy bring a dead server back through the activation system.
 */
@NullMarked
package org.dfra.river.call;

import org.jspecify.annotations.NullMarked;
