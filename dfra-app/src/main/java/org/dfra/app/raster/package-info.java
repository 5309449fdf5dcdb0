/**
 * Two robots search a field by raster.
 *
 * <pre>
 *   world, robots' XML, region --Scenario--&gt; Mission --Flight--&gt; Scores
 *                                            |    '--each moment--&gt; MissionListener
 *                                     LocalMission (lock-step)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.app.raster.Mission}.
 */
@NullMarked
package org.dfra.app.raster;

import org.jspecify.annotations.NullMarked;
