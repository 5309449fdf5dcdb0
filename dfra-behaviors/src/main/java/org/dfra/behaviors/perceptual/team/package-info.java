/**
 * Tracks the other robots of a team by the poses that they report.
 *
 * <pre>
 *   own PoseEstimate -----&gt; OwnPoseBuffer ---own position at that instant--.
 *   others' PoseEstimate -&gt; TeammateTracker --on the robot's own clock-----+--&gt; TeamPositions
 *                              '------timeouts, gaps--&gt; history, log
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.team.TeamTrackerImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.team;

import org.jspecify.annotations.NullMarked;
