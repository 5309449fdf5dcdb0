/**
 * A search by raster in one JVM, with all of the distributed layer except its processes: real
 * lookup services, modules behind their servers and proxies, devices over TCP.
 *
 * <pre>
 *   Simulation --truth--&gt; SimulatedTruth --&gt; MissionMonitor --&gt; MissionResult
 *   robots' registrars &lt;--stop, start-- RegistrarOutage &lt;--every cycle--'
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.examples.mission.embedded.EmbeddedMission}; {@link
 * org.dfra.examples.mission.monitor} monitors the robots.
 */
@NullMarked
package org.dfra.examples.mission.embedded;

import org.jspecify.annotations.NullMarked;
