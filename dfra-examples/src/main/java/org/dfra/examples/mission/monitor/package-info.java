/**
 * A search by raster on a running clock: robots are started through their proxies, monitored by
 * subscriptions, and disturbed by injected faults.
 *
 * <pre>
 *   TruthSource --true poses--&gt; TrueTrajectory -----------.
 *   robots' modules --readings--&gt; RobotSubscriptions --&gt; MissionMonitor --&gt; MissionResult
 *        ^                                                  |
 *        '------faults------ InjectedFault &lt;--every cycle---'
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.examples.mission.monitor.MissionMonitor}. The callers provide the
 * robots' runtime: {@link org.dfra.examples.mission.process} and {@link
 * org.dfra.examples.mission.embedded}.
 */
@NullMarked
package org.dfra.examples.mission.monitor;

import org.jspecify.annotations.NullMarked;
