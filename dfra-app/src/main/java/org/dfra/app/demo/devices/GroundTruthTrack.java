package org.dfra.app.demo.devices;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Where a robot truly was, as {@code ./dfra sim run --truth} wrote it. Immutable. */
final class GroundTruthTrack {

  private static final int COLUMNS = 9;

  /** Slower than this it stands, metres per second. */
  private static final double STANDS = 0.01;

  private record Pose(Instant time, double east, double north, double yaw, double speed) {}

  private final List<Pose> poses;
  private final Instant begin;

  private GroundTruthTrack(List<Pose> poses, Instant begin) {
    this.poses = poses;
    this.begin = begin;
  }

  /** Reads what is there by now, of one robot. */
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

  /** The first time from a moment on at which the robot stood; null where it has not yet. */
  @Nullable Instant stoppedSince(Instant moment) {
    return poses.stream()
        .filter(pose -> !pose.time().isBefore(moment) && pose.speed() < STANDS)
        .map(Pose::time)
        .findFirst()
        .orElse(null);
  }

  /** How fast it was at the last time before a moment, metres per second. */
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

  /** Seconds since the beginning. */
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

  /** Distance from its first place to its last, metres. */
  double closingError() {
    Pose first = poses.get(0);
    Pose last = poses.get(poses.size() - 1);
    return Math.hypot(last.east() - first.east(), last.north() - first.north());
  }

  /**
   * Where its first pose puts a point of the frame in which it started, as {@code {east, north}}.
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
