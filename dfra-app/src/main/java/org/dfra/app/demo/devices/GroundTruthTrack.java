package org.dfra.app.demo.devices;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A robot's ground-truth trajectory, as written by {@code ./dfra sim run --truth}. Immutable. */
final class GroundTruthTrack {

  private static final int COLUMNS = 9;

  /** Below this speed the robot counts as stopped, metres per second. */
  private static final double STANDS = 0.01;

  private record Pose(Instant time, double east, double north, double yaw, double speed) {}

  private final List<Pose> poses;
  private final Instant begin;

  private GroundTruthTrack(List<Pose> poses, Instant begin) {
    this.poses = poses;
    this.begin = begin;
  }

  /** Reads the poses of one robot that have been written so far. */
  static GroundTruthTrack read(Path file, String robot, Instant begin) throws IOException {
    List<Pose> poses = new ArrayList<>();
    for (String line : Files.readAllLines(file)) {
      String[] cells = line.split(",", -1);
      if (cells.length == COLUMNS && cells[1].equals(robot)) {
        poses.add(
            new Pose(
                Instant.parse(cells[0]),
                Double.parseDouble(cells[2]),
                Double.parseDouble(cells[3]),
                Double.parseDouble(cells[5]),
                Math.hypot(Double.parseDouble(cells[6]), Double.parseDouble(cells[7]))));
      }
    }
    if (poses.isEmpty()) {
      throw new IOException(file + " tells nothing of " + robot);
    }
    return new GroundTruthTrack(poses, begin);
  }

  /** The first time after a moment at which the robot is stopped; null if there is none yet. */
  @Nullable Instant stoppedSince(Instant moment) {
    return poses.stream()
        .filter(pose -> !pose.time().isBefore(moment) && pose.speed() < STANDS)
        .map(Pose::time)
        .findFirst()
        .orElse(null);
  }

  /** Its speed at the last sample before a moment, metres per second. */
  double speedAt(Instant moment) {
    double speed = 0;
    for (Pose pose : poses) {
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
    return poses.stream().mapToDouble(Pose::east).toArray();
  }

  double[] north() {
    return poses.stream().mapToDouble(Pose::north).toArray();
  }

  double[] speed() {
    return poses.stream().mapToDouble(Pose::speed).toArray();
  }

  /** Distance between its first and its last position, metres. */
  double closingError() {
    Pose first = poses.get(0);
    Pose last = poses.get(poses.size() - 1);
    return Math.hypot(last.east() - first.east(), last.north() - first.north());
  }

  /**
   * Transforms points from the frame in which the robot started, by its first true pose, to {@code
   * {east, north}}.
   */
  double[][] place(double[] x, double[] y) {
    Pose first = poses.get(0);
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
