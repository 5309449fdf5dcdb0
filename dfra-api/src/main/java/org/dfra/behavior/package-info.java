/**
 * Goal-directed actions of a robot. A behaviour combines perceptual and motor schemas to reach a
 * goal; a script combines behaviours.
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
 * <p>Each is a module that others can find and use, on the same robot or another.
 */
@NullMarked
package org.dfra.behavior;

import org.jspecify.annotations.NullMarked;
