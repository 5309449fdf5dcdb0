/**
 * What a robot does for a purpose. A behaviour joins perceptual and motor schemas to reach a goal;
 * a script joins behaviours.
 *
 * <pre>
 *   RasterSearch (script)
 *        |  a path over the region
 *        v
 *   FollowWaypoints ---&gt; GoToWaypoint ---- asks ----&gt; RangeFilter, HeadingError, FuzzyDrive
 *        ^                    |
 *        |                    '--- commands ---&gt; DriveEffector
 *   ReturnHome
 * </pre>
 *
 * <p>Each is a module that others find and use, on its own robot or another.
 */
@NullMarked
package org.dfra.behavior;

import org.jspecify.annotations.NullMarked;
