package org.dfra.flow.perceptual;

import java.time.Duration;
import java.time.Instant;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.time.ClockOffset;
import org.jspecify.annotations.Nullable;

/**
 * A robot's estimate of its own pose.
 *
 * @param measured time of the estimate, by the robot's clock, UTC
 * @param frame name of the frame, e.g. {@code atrv1/map}: east, north, up at the datum
 * @param datum position of the frame's origin, frame WGS84
 * @param east metres east of the datum, of the robot's base
 * @param north metres north of it
 * @param yaw radians, −π to π; 0 is east, counter-clockwise is +
 * @param speed forward, metres per second
 * @param yawRate radians per second, to the left is +
 * @param positionSigma standard deviation of the position along the direction where it is largest,
 *     metres
 * @param yawSigma standard deviation of the yaw, radians
 * @param fixAge time since an absolute position was last used; null before the first
 * @param clockOffset offset of the robot's clock from UTC as its receivers report it, + is ahead;
 *     null if none reported. Subtract it before comparing the poses of two robots, see {@link
 *     ClockOffset#relativeTo}.
 */
public record PoseEstimate(
    Instant measured,
    String frame,
    GeoPosition datum,
    double east,
    double north,
    double yaw,
    double speed,
    double yawRate,
    double positionSigma,
    double yawSigma,
    @Nullable Duration fixAge,
    @Nullable ClockOffset clockOffset)
    implements Percept {

  public PoseEstimate {
    if (!Double.isFinite(east + north + yaw + speed + yawRate)) {
      throw new IllegalArgumentException(
          "a pose of " + east + " m, " + north + " m, " + yaw + " rad is not finite");
    }
    if (!(positionSigma >= 0 && yawSigma >= 0)) {
      throw new IllegalArgumentException(
          "a standard deviation of " + positionSigma + " m, " + yawSigma + " rad is not >= 0");
    }
  }

  /** The position on the earth, at the datum's height. */
  public GeoPosition position() {
    return new LocalFrame(datum).toGeo(new LocalPosition(east, north, 0));
  }
}
