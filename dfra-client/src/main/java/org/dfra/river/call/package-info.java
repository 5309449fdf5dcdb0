/**
 * How a remote call is sent from this machine, and how its failures are handled.
 *
 * <pre>
 *   caller --&gt; ResurrectingHandler --&gt; DeadlineInvocationHandler --&gt; JERI --&gt; server
 *                 | server ended           | no response in time
 *                 v                        v
 *              activator              DeadlineExceededException
 * </pre>
 *
 * <p>A server chooses both by its exporter. {@link org.dfra.river.call.DeadlineILFactory} gives
 * every call on the exported object a deadline. With {@link
 * org.dfra.river.call.ResurrectingExporter}, the proxy activates an ended server again through the
 * activation system.
 */
@NullMarked
package org.dfra.river.call;

import org.jspecify.annotations.NullMarked;
