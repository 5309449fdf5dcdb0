package org.dfra.examples.devices;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.dfra.sim.run.GroundTruthLog.GroundTruthRow;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.jspecify.annotations.Nullable;

/** A robot's ground-truth trajectory, as written by {@code ./dfra sim run --truth}. Immutable. */
final class GroundTruthTrack {

  private final List<GroundTruthPose> poses;
  private final Instant begin;

  private GroundTruthTrack(List<GroundTruthPose> poses, Instant begin) {
    this.poses = poses;
    this.begin = begin;
  }

  /** Reads the poses of one robot that have been written so far. */
  static GroundTruthTrack read(Path file, String robot, Instant begin) throws IOException {
    List<GroundTruthPose> poses;
    try (Stream<String> lines = Files.lines(file)) {
      poses =
          lines
              .flatMap(line -> GroundTruthRow.parse(line).stream())
              .filter(row -> row.robot().equals(robot))
              .map(GroundTruthRow::pose)
              .toList();
    }
    if (poses.isEmpty()) {
      throw new IOException(file + " has no data of " + robot);
    }
    return new GroundTruthTrack(poses, begin);
  }

  /** The first time after a moment at which the robot is stopped; null if there is none yet. */
  @Nullable Instant stoppedSince(Instant moment) {
    return poses.stream()
        .filter(pose -> !pose.time().isBefore(moment) && pose.isStopped())
        .map(GroundTruthPose::time)
        .findFirst()
        .orElse(null);
  }

  /** Its speed at the last sample before a moment, metres per second. */
  double speedAt(Instant moment) {
    double speed = 0;
    for (GroundTruthPose pose : poses) {
      if (pose.time().isAfter(moment)) {
        break;
      }
      speed = pose.speed();
    }
    return speed;
  }

  /** Seconds since the start. */
  double[] seconds() {
    return poses.stream()
        .mapToDouble(pose -> Duration.between(begin, pose.time()).toNanos() / 1e9)
        .toArray();
  }

  double[] east() {
    return poses.stream().mapToDouble(GroundTruthPose::east).toArray();
  }

  double[] north() {
    return poses.stream().mapToDouble(GroundTruthPose::north).toArray();
  }

  double[] speed() {
    return poses.stream().mapToDouble(GroundTruthPose::speed).toArray();
  }

  /** Distance between its first and its last position, metres. */
  double closingError() {
    GroundTruthPose first = poses.get(0);
    GroundTruthPose last = poses.get(poses.size() - 1);
    return Math.hypot(last.east() - first.east(), last.north() - first.north());
  }

  /**
   * Transforms points from the frame in which the robot started, by its first true pose, to {@code
   * {east, north}}.
   */
  double[][] place(double[] x, double[] y) {
    GroundTruthPose first = poses.get(0);
    double cos = Math.cos(first.yaw());
    double sin = Math.sin(first.yaw());
    double[] east = new double[x.length];
    double[] north = new double[x.length];
    for (int i = 0; i < x.length; i++) {
      east[i] = first.east() + cos * x[i] - sin * y[i];
      north[i] = first.north() + sin * x[i] + cos * y[i];
    }
    return new double[][] {east, north};
  }
}
