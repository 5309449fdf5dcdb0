/**
 * What makes percepts of readings: the first half of every behaviour.
 *
 * <pre>
 *   RangeScan ---------------&gt; RangeFilter ------- Clearance ------.
 *   Odometry, AngularRate, ---&gt; PositionEstimator - PoseEstimate -.  &gt;--&gt; motor schema
 *   GpsFix                                                        v /
 *                                              HeadingError - HeadingPercept
 *   PoseEstimate of all robots -> TeamTracker ---- TeamPositions --> who keeps an eye on others
 *   CameraImage (light, heat) -&gt; MineDetector ---- MinePercept ----&gt; script
 * </pre>
 *
 * <p>No schema here knows what is done with its percepts; several behaviours may use one.
 */
@NullMarked
package org.dfra.flow.perceptual;

import org.jspecify.annotations.NullMarked;
