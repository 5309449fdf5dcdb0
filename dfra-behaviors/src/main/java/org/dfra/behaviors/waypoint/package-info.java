/**
 * Behaviours that drive a robot to waypoints.
 *
 * <pre>
 *   FollowWaypointsImpl --legs--&gt; GoToWaypointImpl: LegExecution, ten times a second:
 *   ReturnHomeImpl ------'           HeadingError, RangeFilter --&gt; FuzzyDrive --&gt; LeasedDrive
 *                                    StuckDetector ------------&gt; RecoveryManeuver ----'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.waypoint.GoToWaypointImpl}.
 */
@NullMarked
package org.dfra.behaviors.waypoint;

import org.jspecify.annotations.NullMarked;
