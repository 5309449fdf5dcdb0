/**
 * Clearance around a robot, from its range sensor.
 *
 * <pre>
 *   RangeScan, Odometry --GhostFilter--&gt; median ranges --ClearanceCalculator--&gt; Clearance
 *                                             '-----ObstacleMemory-----'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.range.RangeFilterImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.range;

import org.jspecify.annotations.NullMarked;
