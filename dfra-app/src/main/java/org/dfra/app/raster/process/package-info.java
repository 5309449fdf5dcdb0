/**
 * A search by raster in real processes: a simulated world, and for each robot phoenix, a registrar
 * and its service groups; and what goes wrong with them on the way.
 *
 * <pre>
 *   simulation's process --truth.csv--&gt; TruthFile --&gt; Watch --&gt; Flight
 *   robots' groups &lt;--kill -9-- troubles &lt;--every moment--'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.raster.process.ProcessMission}; {@link
 * org.dfra.app.raster.monitor} follows the robots.
 */
@NullMarked
package org.dfra.app.raster.process;

import org.jspecify.annotations.NullMarked;
