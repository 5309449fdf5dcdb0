package org.dfra.behaviors.perceptual.mines;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.Optional;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.jspecify.annotations.Nullable;

/**
 * Recent poses of the robot, to locate images at their time. All in one map, with the first pose's
 * datum. Confined to one thread.
 */
final class PoseBuffer {

  private static final int LENGTH = 64;
  private static final Duration FARTHEST = Duration.ofMillis(400);

  private final Deque<PoseEstimate> poses = new ArrayDeque<>();
  private @Nullable LocalFrame map;

  void add(PoseEstimate pose) {
    if (map == null) {
      map = new LocalFrame(pose.datum());
    }
    poses.addLast(pose);
    if (poses.size() > LENGTH) {
      poses.removeFirst();
    }
  }

  /** The pose nearest to a time, at most 0.4 s before or after it. */
  Optional<PoseEstimate> nearest(Instant time) {
    return poses.stream()
        .min(Comparator.comparing(pose -> Duration.between(pose.measured(), time).abs()))
        .filter(pose -> Duration.between(pose.measured(), time).abs().compareTo(FARTHEST) <= 0);
  }

  /** The robot's pose at a time, extrapolated from a pose near to it. */
  Viewpoint extrapolate(Instant time, PoseEstimate pose) {
    double seconds = Duration.between(pose.measured(), time).toNanos() / 1e9;
    double turned = pose.yawRate() * seconds;
    double way = pose.speed() * seconds;
    LocalPosition base = local(pose);
    return new Viewpoint(
        base.east() + way * Math.cos(pose.yaw() + turned / 2),
        base.north() + way * Math.sin(pose.yaw() + turned / 2),
        pose.yaw() + turned);
  }

  private LocalPosition local(PoseEstimate pose) {
    LocalFrame frame = frame();
    return frame.datum().equals(pose.datum())
        ? new LocalPosition(pose.east(), pose.north(), 0)
        : frame.toLocal(pose.position());
  }

  /** The WGS84 position of a map position. */
  GeoPosition toGeo(GroundPoint place) {
    return frame().toGeo(new LocalPosition(place.x(), place.y(), 0));
  }

  private LocalFrame frame() {
    LocalFrame frame = map;
    if (frame == null) {
      throw new IllegalStateException("no pose has been received yet, so there is no map");
    }
    return frame;
  }
}
