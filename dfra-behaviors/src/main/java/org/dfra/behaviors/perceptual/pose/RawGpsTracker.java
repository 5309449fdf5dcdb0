package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * The last fix of any receiver, unfiltered; for comparison. The yaw is the last course, which
 * assumes forward motion; it is used to remove the lever arm. Confined to one thread.
 */
final class RawGpsTracker implements PoseTracker {

  private final TrackerSettings settings;
  private final FixPreprocessor intake;
  private final PoseEstimateFactory poses;
  private @Nullable LocalFix last;
  private double yaw;
  private double yawSigma = FixWindow.UNKNOWN_YAW_SIGMA;

  /**
   * @param frame name of the frame of its estimates
   * @param datum origin of that frame; null to use the position of the first fix
   */
  public RawGpsTracker(TrackerSettings settings, String frame, @Nullable GeoPosition datum) {
    this.settings = settings;
    this.intake = new FixPreprocessor(settings.gps(), datum);
    this.poses = new PoseEstimateFactory(frame, intake);
  }

  @Override
  public void addMeasurement(Odometry odometry) {}

  @Override
  public void addMeasurement(AngularRate rate) {}

  @Override
  public void addMeasurement(GpsFix fix, String source, Transform antenna, Instant received) {
    LocalFix local = intake.process(fix, source, antenna, received);
    if (local == null) {
      return;
    }
    if (last == null
        || local.time() >= last.time()
        || last.time() - local.time() > TimestampMonitor.MAX_STEP_NANOS) {
      last = local;
      if (!Double.isNaN(local.course())) {
        yaw = local.course();
        yawSigma = settings.gps().courseSigma(local.speed());
      }
    }
  }

  @Override
  public Optional<PoseEstimate> estimate(Instant now) {
    LocalFix fix = last;
    if (fix == null) {
      return Optional.empty();
    }
    double cos = Math.cos(yaw);
    double sin = Math.sin(yaw);
    boolean knowsYaw = yawSigma < 1;
    double forward = knowsYaw ? fix.forward() : 0;
    double left = knowsYaw ? fix.left() : 0;
    PoseEstimateFactory.UncertainPose found =
        new PoseEstimateFactory.UncertainPose(
            fix.east() - cos * forward + sin * left,
            fix.north() - sin * forward - cos * left,
            yaw,
            Math.hypot(fix.sigma(), settings.gps().biasSigma()),
            yawSigma);
    return poses.estimate(
        Math.max(EpochNanos.of(now), fix.time()), found, fix.speed(), 0, fix.time());
  }
}
