/**
 * The emergency stop of every robot that can be reached.
 *
 * <pre>
 *   PhoenixAddresses --&gt; PhoenixStopRequests: each phoenix   -+
 *   EffectorSearch   --&gt; FairCallScheduler: proxies in turn  -+-&gt; StopMerge --&gt; Outcome
 *   LocalEffectors   --&gt; StopDispatcher: this host's phoenix -+
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.app.stop.StopCommand}; {@link org.dfra.app.stop.StopDispatcher}
 * schedules the calls.
 */
@NullMarked
package org.dfra.app.stop;

import org.jspecify.annotations.NullMarked;
