package org.dfra.app.demo.recruit;

import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.dfra.app.raster.live.TrueWay;
import org.dfra.sim.world.TruePose;
import org.dfra.sim.world.Truth;

/**
 * Where the robots of the demonstration truly go: the world is asked five times a second by a
 * thread of its own, {@code dfra-demo-ways}. Safe for use by several threads.
 */
final class Ways implements AutoCloseable {

  private static final long PERIOD_MILLIS = 200;

  private final List<String> robots;
  private final Truth truth;
  private final InstantSource clock;
  private final TrueWay known = new TrueWay(); // guarded by this
  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread made = new Thread(task, "dfra-demo-ways");
            made.setDaemon(true);
            return made;
          });

  /**
   * @param clock by which the world goes
   */
  Ways(List<String> robots, Truth truth, InstantSource clock) {
    this.robots = List.copyOf(robots);
    this.truth = truth;
    this.clock = clock;
  }

  /** Begins to ask; the world runs. */
  void start() {
    look();
    var unused =
        thread.scheduleAtFixedRate(this::look, PERIOD_MILLIS, PERIOD_MILLIS, TimeUnit.MILLISECONDS);
  }

  private synchronized void look() {
    truth.poses(clock.instant()).forEach(known::add);
  }

  /** Where a robot was at that time, or just before. */
  synchronized TruePose at(String robot, Instant time) {
    TruePose pose = known.at(time).get(robot);
    if (pose == null) {
      throw new IllegalArgumentException(robot + " is not in the world");
    }
    return pose;
  }

  /** How far a robot is from where it was at that time, as the crow flies, metres. */
  synchronized double since(String robot, Instant time) {
    TruePose before = at(robot, time);
    TruePose now = at(robot, known.newest());
    return Math.hypot(now.east() - before.east(), now.north() - before.north());
  }

  /**
   * Of each robot {@code {east, north}}, metres in the world's frame, in the order of the robots.
   */
  synchronized Map<String, double[][]> all() {
    Map<String, double[][]> all = new LinkedHashMap<>();
    for (String robot : robots) {
      List<TruePose> way = known.of(robot);
      all.put(
          robot,
          new double[][] {
            way.stream().mapToDouble(TruePose::east).toArray(),
            way.stream().mapToDouble(TruePose::north).toArray()
          });
    }
    return all;
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }
}
