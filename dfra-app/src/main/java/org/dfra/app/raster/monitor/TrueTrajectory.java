package org.dfra.app.raster.monitor;

import java.io.IOException;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Map.Entry;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.dfra.sim.world.GroundTruthPose;
import org.jspecify.annotations.Nullable;

/** Where robots truly were, as far as is known. Confined to one thread. */
public final class TrueTrajectory {

  /** Slower than this a robot stands, metres per second. */
  private static final double STOPPED_SPEED = 0.01;

  private final Map<String, NavigableMap<Instant, GroundTruthPose>> poses =
      new HashMap<>(); // by robot
  private Instant newest = Instant.MIN;

  /** Takes where a robot was, at a time that is not before the last one of any robot. */
  public void add(String robot, GroundTruthPose pose) {
    poses.computeIfAbsent(robot, unused -> new TreeMap<>()).put(pose.time(), pose);
    newest = pose.time();
  }

  /** The time up to which it is known; {@link Instant#MIN} before the first line. */
  public Instant latestTime() {
    return newest;
  }

  /** Where every robot was, at that time or just before. */
  public Map<String, GroundTruthPose> at(Instant time) {
    Map<String, GroundTruthPose> all = new HashMap<>();
    poses.forEach(
        (robot, known) -> {
          @Nullable Entry<Instant, GroundTruthPose> found = known.floorEntry(time);
          all.put(robot, found == null ? known.firstEntry().getValue() : found.getValue());
        });
    return all;
  }

  /** Where a robot was, the first first; nothing of one that is not in the world. */
  public List<GroundTruthPose> of(String robot) {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    return known == null ? List.of() : List.copyOf(known.values());
  }

  /** Where a robot is, as far as is known. */
  public GroundTruthPose last(String robot) throws IOException {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    if (known == null) {
      throw new IOException("the simulation tells nothing of " + robot + "; is it in the world?");
    }
    return known.lastEntry().getValue();
  }

  /** The first time from a moment on at which a robot stood; null where it has not yet. */
  public @Nullable Instant stoppedSince(String robot, Instant moment) {
    @Nullable NavigableMap<Instant, GroundTruthPose> known = poses.get(robot);
    return known == null
        ? null
        : known.tailMap(moment, true).values().stream()
            .filter(pose -> pose.speed() < STOPPED_SPEED)
            .map(GroundTruthPose::time)
            .findFirst()
            .orElse(null);
  }
}
