package org.dfra.behaviors.perceptual.team;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import org.dfra.flow.perceptual.PoseEstimate;
import org.jspecify.annotations.Nullable;

/**
 * Recent poses of the robot itself, to get its position at the instant of another robot's pose.
 * Confined to one thread at a time.
 */
final class OwnPoseBuffer {

  private static final Duration KEPT = Duration.ofSeconds(5);

  /** Maximum time between two poses for interpolation. */
  private static final Duration WIDEST = Duration.ofSeconds(1);

  /**
   * A position at an instant of the robot's clock.
   *
   * @param east metres, in the frame of the robot's poses
   * @param north likewise
   * @param nearest the pose of the two around it that is nearer in time
   */
  record InterpolatedPosition(double east, double north, PoseEstimate nearest) {}

  private final Deque<PoseEstimate> poses = new ArrayDeque<>();

  /** Adds the newest pose. One with an earlier time or another datum clears the buffer. */
  void add(PoseEstimate pose) {
    @Nullable PoseEstimate last = poses.peekLast();
    if (last != null
        && (!pose.measured().isAfter(last.measured()) || !pose.datum().equals(last.datum()))) {
      poses.clear();
    }
    poses.addLast(pose);
    while (isOlder(poses.getFirst(), pose.measured().minus(KEPT))) {
      poses.removeFirst();
    }
  }

  private static boolean isOlder(PoseEstimate pose, Instant time) {
    return pose.measured().isBefore(time);
  }

  /** The newest pose; null before the first. */
  @Nullable PoseEstimate newest() {
    return poses.peekLast();
  }

  /** The robot's position at a time of its clock; null where that is not between two poses. */
  @Nullable InterpolatedPosition at(Instant time) {
    @Nullable PoseEstimate before = null;
    for (PoseEstimate after : poses) {
      if (after.measured().equals(time)) {
        return new InterpolatedPosition(after.east(), after.north(), after);
      }
      if (after.measured().isAfter(time)) {
        return before == null ? null : between(before, after, time);
      }
      before = after;
    }
    return null;
  }

  private static @Nullable InterpolatedPosition between(
      PoseEstimate before, PoseEstimate after, Instant time) {
    Duration step = Duration.between(before.measured(), after.measured());
    if (step.compareTo(WIDEST) > 0) {
      return null;
    }
    double part =
        (double) Duration.between(before.measured(), time).toNanos() / step.toNanos(); // 0 to 1
    return new InterpolatedPosition(
        before.east() + part * (after.east() - before.east()),
        before.north() + part * (after.north() - before.north()),
        part < 0.5 ? before : after);
  }
}
