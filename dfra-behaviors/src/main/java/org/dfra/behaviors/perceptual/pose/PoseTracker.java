package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.Transform;

/**
 * Follows the pose of one robot through its readings. Confined to one thread. It knows no time but
 * that of the readings and arguments. Readings may be late, repeated, out of order, missing or
 * nonsense: what cannot be used is left out, and nothing is thrown.
 *
 * <p>Two clocks meet here. Odometry and angular rates are stamped by the robot's clock, fixes by
 * UTC from space. The difference is learnt from when fixes are heard, see {@link
 * UtcOffsetEstimator}.
 */
public interface PoseTracker {

  /** Takes how far the wheels went; stamped by the robot's clock. */
  void addMeasurement(Odometry odometry);

  /** Takes how fast a gyro turns whose z axis is the robot's; stamped by the robot's clock. */
  void addMeasurement(AngularRate rate);

  /**
   * Takes a fix. It counts for the time that it is of, not for the time at which it was heard.
   *
   * @param source name of the receiver; each has errors of its own
   * @param antenna where the antenna is in the robot's base
   * @param received when this host heard it, by the robot's clock
   */
  void addMeasurement(GpsFix fix, String source, Transform antenna, Instant received);

  /**
   * Where the robot is; empty until it can be said at all. The yaw may be unknown at first, which
   * its standard deviation tells: {@value FixWindow#UNKNOWN_YAW_SIGMA} rad is that of any yaw at
   * all.
   *
   * @param now by the robot's clock; the last motion is taken to go on until then, for a short
   *     while. Earlier than the last odometry, the estimate is of the time of that.
   */
  Optional<PoseEstimate> estimate(Instant now);
}
