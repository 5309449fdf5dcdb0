/**
 * What a robot knows of the others of its team, by the poses that they tell.
 *
 * <pre>
 *   own PoseEstimate ----> OwnPoseBuffer --where it was at that instant--.
 *   others' PoseEstimate -> TeammateTracker --on the robot's own clock-----+--> TeamPositions
 *                              '------silence, gaps--> history, log
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.team.TeamTrackerImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.team;

import org.jspecify.annotations.NullMarked;
