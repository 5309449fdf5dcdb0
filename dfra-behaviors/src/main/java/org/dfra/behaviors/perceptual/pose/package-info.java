/**
 * Position estimation: fusion of odometry, gyro and satellite fixes.
 *
 * <pre>
 *   AngularRate -&gt; GyroIntegrator -.
 *   Odometry -- MotionIncrementBuilder -&gt; DeadReckoningTrack -- FixWindow -&gt; FixWindowTracker
 *                                \                                  \ first yaw
 *   GpsFix -&gt; FixPreprocessor -&gt; LocalFix --&gt; DelayedFixFilter -&gt; Belief --&gt; KalmanTracker
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.pose.PoseTracker}; its kinds are listed in
 * {@link org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl.TrackerKind}. The module that
 * uses them is {@link org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.pose;

import org.jspecify.annotations.NullMarked;
