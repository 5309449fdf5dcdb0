package org.dfra.examples.mission.monitor;

import java.io.IOException;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.jspecify.annotations.Nullable;

/** The robots' true trajectories, as far as known. Confined to one thread. */
public final class TrueTrajectory {

  private final Map<String, NavigableMap<Instant, GroundTruthPose>> poses =
      new HashMap<>(); // by robot
  private Instant newest = Instant.MIN;

  /** Adds a robot's pose, at a time not before the last one of any robot. */
  public void add(String robot, GroundTruthPose pose) {
    poses.computeIfAbsent(robot, unused -> new TreeMap<>()).put(pose.time(), pose);
    newest = pose.time();
  }

  /** The time up to which it is known; {@link Instant#MIN} before the first line. */
  public Instant latestTime() {
    return newest;
  }

  /** The pose of every robot at that time or just before. */
  public Map<String, GroundTruthPose> at(Instant time) {
    Map<String, GroundTruthPose> all = new HashMap<>();
    poses.forEach(
        (robot, known) -> {
          @Nullable Entry<Instant, GroundTruthPose> found = known.floorEntry(time);
          all.put(robot, found == null ? known.firstEntry().getValue() : found.getValue());
        });
    return all;
  }

  /** A robot's poses, the first first; empty for a robot that is not in the world. */
  public List<GroundTruthPose> of(String robot) {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    return known == null ? List.of() : List.copyOf(known.values());
  }

  /** A robot's latest known pose. */
  public GroundTruthPose last(String robot) throws IOException {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    if (known == null) {
      throw new IOException(
          "the simulation has no data of " + robot + "; check that the world has this robot");
    }
    return known.lastEntry().getValue();
  }

  /** The first time after a moment at which a robot is stopped; null if there is none yet. */
  public @Nullable Instant stoppedSince(String robot, Instant moment) {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    return known == null
        ? null
        : known.tailMap(moment, true).values().stream()
            .filter(GroundTruthPose::isStopped)
            .map(GroundTruthPose::time)
            .findFirst()
            .orElse(null);
  }
}
