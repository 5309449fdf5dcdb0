/**
 * Where a robot is: wheels, gyro and satellites put together.
 *
 * <pre>
 *   AngularRate -&gt; GyroIntegrator -.
 *   Odometry ----------------- Steps --&gt; Track ---- FixWindow --&gt; FixWindowTracker
 *                                \                     \ first yaw
 *   GpsFix -&gt; FixPreprocessor -&gt; LocalFix ------&gt; Replay -&gt; Belief ---&gt; KalmanTracker
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.pose.PoseTracker}; its kinds are listed in
 * {@link org.dfra.behaviors.perceptual.pose.TrackerKind}. A module around them is {@link
 * org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.pose;

import org.jspecify.annotations.NullMarked;
