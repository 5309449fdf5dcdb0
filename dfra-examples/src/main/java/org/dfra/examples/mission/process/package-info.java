/**
 * A search by raster in real processes: a simulated world, and for each robot phoenix, a registrar
 * and its service groups; and the faults injected into them.
 *
 * <pre>
 *   simulation's process --truth.csv--&gt; TruthFile --&gt; MissionMonitor --&gt; MissionResult
 *   robots' groups &lt;--kill -9-- InjectedFault &lt;--every cycle--'
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.examples.mission.process.ProcessMission}; {@link
 * org.dfra.examples.mission.monitor} monitors the robots.
 */
@NullMarked
package org.dfra.examples.mission.process;

import org.jspecify.annotations.NullMarked;
