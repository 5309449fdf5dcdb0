package org.dfra.behaviors.perceptual.pose;

import java.time.Instant;
import java.util.Optional;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;

/**
 * The heuristic: dead reckoning laid over the fixes of the last seconds, see {@link FixWindow}. It
 * knows nothing but these, so it forgets its errors, and its certainties, within the window.
 * Without a fix in the window the last alignment goes on. Confined to one thread.
 */
public final class HistoryTracker implements PoseTracker {

  private final TrackerSettings settings;
  private final FixIntake intake;
  private final Poses poses;
  private final Reckoning reckoning;
  private @Nullable LocalFix last;

  /**
   * @param frame name of the frame of its estimates
   * @param datum origin of that frame; null for the position of the first fix
   */
  public HistoryTracker(TrackerSettings settings, String frame, @Nullable GeoPosition datum) {
    this.settings = settings;
    this.intake = new FixIntake(settings.gps(), datum);
    this.poses = new Poses(frame, intake);
    this.reckoning = new Reckoning(settings);
  }

  @Override
  public void take(Odometry odometry) {
    reckoning.take(odometry);
  }

  @Override
  public void take(AngularRate rate) {
    reckoning.take(rate);
  }

  @Override
  public void take(GpsFix fix, String source, Transform antenna, Instant received) {
    LocalFix local = intake.take(fix, source, antenna, received);
    if (local == null) {
      return;
    }
    if (local.isNewSource()) {
      reckoning.window().clear();
    }
    reckoning.catchUp(local.time());
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
    long time = Math.max(Ticks.of(now), reckoning.steps().time());
    return poses.estimate(
        time,
        found(aligned.get(), reckoning.ahead(time), settings),
        reckoning.steps().speed(),
        reckoning.turnRate(),
        fix.time());
  }

  /** Where a place on the track is in the map. */
  static Poses.Found found(Alignment alignment, Track.Pose pose, TrackerSettings settings) {
    return new Poses.Found(
        alignment.east() + alignment.eastward(pose),
        alignment.north() + alignment.northward(pose),
        alignment.yaw() + pose.yaw(),
        alignment.positionSigma(pose, settings.gps().bias()),
        alignment.yawSigma());
  }
}
