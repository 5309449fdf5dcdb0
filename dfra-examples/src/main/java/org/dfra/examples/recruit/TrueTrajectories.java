package org.dfra.examples.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.examples.mission.monitor.TrueTrajectory;
import org.dfra.sim.world.GroundTruth;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;

/**
 * The true paths of the demonstration's robots: a thread of its own, {@code dfra-demo-ways},
 * samples the world five times a second. Thread-safe.
 */
final class TrueTrajectories implements AutoCloseable {

  private static final long PERIOD_MILLIS = 200;

  private final List<String> robots;
  private final GroundTruth truth;
  private final InstantSource clock;

  @GuardedBy("this")
  private final TrueTrajectory known = new TrueTrajectory();

  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread made = new Thread(task, "dfra-demo-ways");
            made.setDaemon(true);
            return made;
          });

  /**
   * @param clock the world's clock
   */
  TrueTrajectories(List<String> robots, GroundTruth truth, InstantSource clock) {
    this.robots = List.copyOf(robots);
    this.truth = truth;
    this.clock = clock;
  }

  /** Starts the sampling; the world runs. */
  void start() {
    look();
    var unused =
        thread.scheduleAtFixedRate(this::look, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
  }

  private synchronized void look() {
    truth.poses(clock.instant()).forEach(known::add);
  }

  /** A robot's position at that time, or just before. */
  synchronized GroundTruthPose at(String robot, Instant time) {
    GroundTruthPose pose = known.at(time).get(robot);
    if (pose == null) {
      throw new IllegalArgumentException(robot + " is not in the world");
    }
    return pose;
  }

  /** Straight-line distance of a robot from its position at that time, metres. */
  synchronized double displacementSince(String robot, Instant time) {
    GroundTruthPose before = at(robot, time);
    GroundTruthPose now = at(robot, known.latestTime());
    return Math.hypot(now.east() - before.east(), now.north() - before.north());
  }

  /**
   * The path of each robot {@code {east, north}}, metres in the world's frame, in the order of the
   * robots.
   */
  synchronized Map<String, double[][]> all() {
    Map<String, double[][]> all = new LinkedHashMap<>();
    for (String robot : robots) {
      List<GroundTruthPose> way = known.of(robot);
      all.put(
          robot,
          new double[][] {
            way.stream().mapToDouble(GroundTruthPose::east).toArray(),
            way.stream().mapToDouble(GroundTruthPose::north).toArray()
          });
    }
    return all;
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }
}
