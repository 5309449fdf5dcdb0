/**
 * Where a robot is: wheels, gyro and satellites put together.
 *
 * <pre>
 *   AngularRate -&gt; GyroTurns -.
 *   Odometry ----------------- Steps --&gt; Track ---- FixWindow --&gt; HistoryTracker
 *                                \                     \ first yaw
 *   GpsFix -&gt; FixIntake -&gt; LocalFix ------&gt; Replay -&gt; Belief ---&gt; KalmanTracker
 * </pre>
 *
 * <p>Enter at {@link org.dfra.behaviors.perceptual.pose.PoseTracker}; its kinds are listed in
 * {@link org.dfra.behaviors.perceptual.pose.TrackerKind}. A module around them is {@link
 * org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl}.
 */
@NullMarked
package org.dfra.behaviors.perceptual.pose;

import org.jspecify.annotations.NullMarked;
