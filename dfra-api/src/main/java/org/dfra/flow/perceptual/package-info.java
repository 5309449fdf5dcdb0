/**
 * Perceptual schemas: they compute percepts from readings, the first half of every behaviour.
 *
 * <pre>
 *   RangeScan ---------------&gt; RangeFilter ------- Clearance ------.
 *   Odometry, AngularRate, ---&gt; PositionEstimator - PoseEstimate -.  &gt;--&gt; motor schema
 *   GpsFix                                                        v /
 *                                              HeadingError - HeadingPercept
 *   PoseEstimate of all robots -&gt; TeamTracker ---- TeamPositions --&gt; recruitment, team displays
 *   CameraImage (light, heat) -&gt; MineDetector ---- MinePercept ----&gt; script
 * </pre>
 *
 * <p>A schema is independent of the use of its percepts; several behaviours may share one.
 */
@NullMarked
package org.dfra.flow.perceptual;

import org.jspecify.annotations.NullMarked;
