/**
 * The room around a robot, from its range sensor.
 *
 * <pre>
 *   RangeScan, Odometry --GhostFilter--&gt; ranges of the last scans --Surrounds--&gt; Clearance
 *                                                      '---Passed---'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.range.RangeFilterImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.range;

import org.jspecify.annotations.NullMarked;
