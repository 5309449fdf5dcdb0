/**
 * A search by raster in one virtual machine, with all of the distributed layer but its processes:
 * real lookup services, modules behind their servers and proxies, devices over TCP.
 *
 * <pre>
 *   Simulation --truth--&gt; SimulatedTruth --&gt; Watch --&gt; Flight
 *   robots' registrars &lt;--ended, started-- LostRegistrar &lt;--every moment--'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.raster.embedded.EmbeddedMission}; {@link
 * org.dfra.app.raster.monitor} follows the robots.
 */
@NullMarked
package org.dfra.app.raster.embedded;

import org.jspecify.annotations.NullMarked;
