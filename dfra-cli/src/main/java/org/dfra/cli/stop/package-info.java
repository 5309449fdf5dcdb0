/**
 * The emergency stop of every robot that can be reached.
 *
 * <pre>
 *   PhoenixAddresses --&gt; PhoenixStopRequests: each phoenix   -+
 *   EffectorSearch   --&gt; FairCallScheduler: proxies in turn  -+-&gt; StopMerge --&gt; Outcome
 *   LocalEffectors   --&gt; StopDispatcher: this host's phoenix -+
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.cli.stop.StopCommand}; {@link org.dfra.cli.stop.StopDispatcher}
 * schedules the calls.
 */
@NullMarked
package org.dfra.cli.stop;

import org.jspecify.annotations.NullMarked;
