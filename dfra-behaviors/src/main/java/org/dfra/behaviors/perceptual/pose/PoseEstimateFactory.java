package org.dfra.behaviors.perceptual.pose;

import java.time.Duration;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;

/** Creates estimates in one frame. */
final class PoseEstimateFactory {

  private final String frame;
  private final FixPreprocessor intake;

  PoseEstimateFactory(String frame, FixPreprocessor intake) {
    this.frame = frame;
    this.intake = intake;
  }

  /** A position with its yaw and the uncertainty of both; units as in {@link PoseEstimate}. */
  record UncertainPose(
      double east, double north, double yaw, double positionSigma, double yawSigma) {}

  /**
   * Creates the estimate; empty where there is no datum yet or a number is not finite.
   *
   * @param time nanoseconds by the robot's clock
   * @param used time of the last fix that was used, likewise
   */
  Optional<PoseEstimate> estimate(
      long time, UncertainPose found, double speed, double yawRate, long used) {
    Optional<GeoPosition> datum = intake.datum();
    double sum =
        found.east + found.north + found.yaw + found.positionSigma + found.yawSigma + speed;
    if (datum.isEmpty() || !Double.isFinite(sum + yawRate)) {
      return Optional.empty();
    }
    return Optional.of(
        new PoseEstimate(
            EpochNanos.instant(time),
            frame,
            datum.get(),
            found.east,
            found.north,
            Math.IEEEremainder(found.yaw, 2 * Math.PI),
            speed,
            yawRate,
            found.positionSigma,
            Math.min(FixWindow.UNKNOWN_YAW_SIGMA, found.yawSigma),
            Duration.ofNanos(Math.max(0, time - used)),
            intake.clockOffset(time).orElse(null)));
  }
}
