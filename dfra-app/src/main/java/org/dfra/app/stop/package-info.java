/**
 * The emergency stop of every robot that can be reached.
 *
 * <pre>
 *   PhoenixAddresses --&gt; PhoenixStopRequests  each phoenix, directly     -+
 *   EffectorSearch   --&gt; FairCallScheduler       each proxy, round robin    -+-&gt; StopMerge --&gt; Outcome
 *   LocalEffectors   --&gt; StopDispatcher       by this host's phoenix     -+
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.stop.StopCommand}; whom it calls, and how often, is {@link
 * org.dfra.app.stop.StopDispatcher}'s.
 */
@NullMarked
package org.dfra.app.stop;

import org.jspecify.annotations.NullMarked;
