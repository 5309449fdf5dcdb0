package org.dfra.app.sim;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.sim.world.Collision;
import org.dfra.sim.world.TruePose;
import org.dfra.sim.world.World;

/**
 * How a simulated world is.
 *
 * @param time its time
 * @param elapsed simulated time since it began
 * @param robots where each robot truly is
 * @param collisions how many there were so far
 * @param fresh those of them that the state before this one did not know
 */
public record State(
    Instant time, Duration elapsed, List<Place> robots, int collisions, List<Collision> fresh) {

  public State {
    robots = List.copyOf(robots);
    fresh = List.copyOf(fresh);
  }

  /**
   * Where a robot truly is.
   *
   * @param robot its name
   * @param east metres from the datum
   * @param north metres from the datum
   * @param up metres above the ground
   * @param yaw radians, 0 is east, counter-clockwise is +
   * @param speed over ground, metres per second
   */
  public record Place(
      String robot, double east, double north, double up, double yaw, double speed) {}

  /**
   * The state now.
   *
   * @param known how many collisions the last state knew
   */
  static State of(World world, Instant begin, Instant now, int known) {
    List<Place> robots =
        world.truth().poses(now).entrySet().stream()
            .map(each -> place(each.getKey(), each.getValue()))
            .toList();
    List<Collision> all = world.truth().collisions();
    return new State(
        now, Duration.between(begin, now), robots, all.size(), all.subList(known, all.size()));
  }

  private static Place place(String robot, TruePose pose) {
    return new Place(robot, pose.east(), pose.north(), pose.up(), pose.yaw(), pose.speed());
  }

  /** {@code 12 s atrv1 3.2 m E 4.0 m N 0.5 m/s; 0 collisions}. */
  String inWords() {
    return String.format(Locale.ROOT, "%.0f s  ", elapsed.toNanos() / 1e9)
        + robots.stream()
            .map(
                each ->
                    String.format(
                        Locale.ROOT,
                        "%s %.1f m E %.1f m N%s %.1f m/s",
                        each.robot(),
                        each.east(),
                        each.north(),
                        each.up() > 0.05 ? String.format(Locale.ROOT, " %.1f m up", each.up()) : "",
                        each.speed()))
            .collect(Collectors.joining(", "))
        + "; "
        + collisions
        + (collisions == 1 ? " collision" : " collisions");
  }
}
