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
 * The heuristic: dead reckoning aligned to the fixes of the last seconds, see {@link FixWindow}. It
 * uses only these, so errors, and certainty, persist no longer than the window. Without a fix in
 * the window it keeps the last alignment. Confined to one thread.
 */
final class FixWindowTracker implements PoseTracker {

  private final TrackerSettings settings;
  private final FixPreprocessor intake;
  private final PoseEstimateFactory poses;
  private final DeadReckoning reckoning;
  private @Nullable LocalFix last;

  /**
   * @param frame name of the frame of its estimates
   * @param datum origin of that frame; null to use the position of the first fix
   */
  public FixWindowTracker(TrackerSettings settings, String frame, @Nullable GeoPosition datum) {
    this.settings = settings;
    this.intake = new FixPreprocessor(settings.gps(), datum);
    this.poses = new PoseEstimateFactory(frame, intake);
    this.reckoning = new DeadReckoning(settings);
  }

  @Override
  public void addMeasurement(Odometry odometry) {
    reckoning.take(odometry);
  }

  @Override
  public void addMeasurement(AngularRate rate) {
    reckoning.take(rate);
  }

  @Override
  public void addMeasurement(GpsFix fix, String source, Transform antenna, Instant received) {
    LocalFix local = intake.process(fix, source, antenna, received);
    if (local == null) {
      return;
    }
    if (local.isNewSource()) {
      reckoning.window().clear();
    }
    reckoning.advanceTo(local.time());
    reckoning.add(local);
    last = local;
  }

  @Override
  public Optional<PoseEstimate> estimate(Instant now) {
    LocalFix fix = last;
    Optional<Alignment> aligned = reckoning.align();
    if (fix == null || aligned.isEmpty()) {
      return Optional.empty();
    }
    long time = Math.max(EpochNanos.of(now), reckoning.steps().time());
    return poses.estimate(
        time,
        toPose(aligned.get(), reckoning.predict(time), settings),
        reckoning.steps().speed(),
        reckoning.yawRate(),
        fix.time());
  }

  /** Transforms a point on the track to the map. */
  static PoseEstimateFactory.UncertainPose toPose(
      Alignment alignment, DeadReckoningTrack.Pose pose, TrackerSettings settings) {
    return new PoseEstimateFactory.UncertainPose(
        alignment.east() + alignment.eastward(pose),
        alignment.north() + alignment.northward(pose),
        alignment.yaw() + pose.yaw(),
        alignment.positionSigma(pose, settings.gps().biasSigma()),
        alignment.yawSigma());
  }
}
