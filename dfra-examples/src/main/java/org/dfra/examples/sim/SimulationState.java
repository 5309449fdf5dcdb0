package org.dfra.examples.sim;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.World;

/**
 * The state of a simulated world.
 *
 * @param time its time
 * @param elapsed simulated time since it began
 * @param robots the robots' true poses
 * @param collisions number of collisions so far
 * @param newCollisions those since the previous state
 */
public record SimulationState(
    Instant time,
    Duration elapsed,
    List<RobotState> robots,
    int collisions,
    List<Collision> newCollisions) {

  public SimulationState {
    robots = List.copyOf(robots);
    newCollisions = List.copyOf(newCollisions);
  }

  /**
   * A robot's true pose.
   *
   * @param robot its name
   * @param east metres from the datum
   * @param north metres from the datum
   * @param up metres above the ground
   * @param yaw radians, 0 is east, counter-clockwise is +
   * @param speed over ground, metres per second
   */
  public record RobotState(
      String robot, double east, double north, double up, double yaw, double speed) {}

  /**
   * The current state.
   *
   * @param known number of collisions in the previous state
   */
  static SimulationState of(World world, Instant begin, Instant now, int known) {
    List<RobotState> robots =
        world.groundTruth().poses(now).entrySet().stream()
            .map(each -> place(each.getKey(), each.getValue()))
            .toList();
    List<Collision> all = world.groundTruth().collisions();
    return new SimulationState(
        now, Duration.between(begin, now), robots, all.size(), all.subList(known, all.size()));
  }

  private static RobotState place(String robot, GroundTruthPose pose) {
    return new RobotState(robot, pose.east(), pose.north(), pose.up(), pose.yaw(), pose.speed());
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
