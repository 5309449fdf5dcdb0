/**
 * Searches of a field by raster with several robots.
 *
 * <pre>
 *   world, robots' XML, region --Scenario--&gt; Mission --MissionResult--&gt; Scores
 *                                            | '--progress--&gt; MissionProgressListener
 *                                     LockStepMission (lock-step)
 * </pre>
 *
 * <p>Entry point: {@link org.dfra.examples.mission.Mission}.
 */
@NullMarked
package org.dfra.examples.mission;

import org.jspecify.annotations.NullMarked;
