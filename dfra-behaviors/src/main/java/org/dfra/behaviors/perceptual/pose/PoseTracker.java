package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.Transform;

/**
 * Tracks the pose of one robot from its readings. Confined to one thread. It uses only the times of
 * readings and arguments. Readings may be late, duplicate, out of order, missing or invalid:
 * unusable ones are dropped without an exception.
 *
 * <p>It uses two clocks. Odometry and angular rates have timestamps of the robot's clock, fixes
 * have GNSS UTC. The offset is estimated from the reception times of fixes, see {@link
 * UtcOffsetEstimator}.
 */
interface PoseTracker {

  /** Adds odometry, with a timestamp of the robot's clock. */
  void addMeasurement(Odometry odometry);

  /** Adds the rate of a gyro whose z axis is the robot's, with a timestamp of the robot's clock. */
  void addMeasurement(AngularRate rate);

  /**
   * Adds a fix. It is used at its own time, not at its reception time.
   *
   * @param source name of the receiver; receivers have separate errors
   * @param antenna position in the frame of the robot's base
   * @param received reception time, by the robot's clock
   */
  void addMeasurement(GpsFix fix, String source, Transform antenna, Instant received);

  /**
   * The robot's pose; empty until it can be computed. The yaw may be unknown at first, with the
   * standard deviation of a uniform distribution: {@value FixWindow#UNKNOWN_YAW_SIGMA} rad.
   *
   * @param now by the robot's clock; the last motion is extrapolated until then, for a short time.
   *     If it is earlier than the last odometry, the estimate has the time of that.
   */
  Optional<PoseEstimate> estimate(Instant now);
}
