/**
 * Behaviours that bring a robot somewhere.
 *
 * <pre>
 *   FollowWaypointsImpl --legs--&gt; GoToWaypointImpl: LegExecution, ten times a second:
 *   ReturnHomeImpl ------'           HeadingError, RangeFilter --&gt; FuzzyDrive --&gt; Wheels
 *                                    StuckDetector ---------------&gt; Recovery -----'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.waypoint.GoToWaypointImpl}.
 */
@NullMarked
package org.dfra.behaviors.waypoint;

import org.jspecify.annotations.NullMarked;
