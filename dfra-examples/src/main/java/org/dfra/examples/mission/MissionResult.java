package org.dfra.examples.mission;

import java.util.List;
import java.util.Map;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;
import org.dfra.examples.mission.RobotLog.Sample;
import org.dfra.sim.world.GroundTruth.Collision;

/**
 * The result of a search.
 *
 * @param robots one for each robot
 * @param collisions all collisions
 * @param events events during the search, collisions included, in order of time
 * @param seconds its duration, by the robots' time
 */
public record MissionResult(
    List<RobotMissionResult> robots,
    List<Collision> collisions,
    List<MissionEvent> events,
    double seconds) {

  public MissionResult {
    robots = List.copyOf(robots);
    collisions = List.copyOf(collisions);
    events = List.copyOf(events);
  }

  /** The same without the large parts. */
  public MissionResult withoutSamples() {
    return new MissionResult(
        robots.stream()
            .map(
                r ->
                    new RobotMissionResult(
                        r.robot(),
                        r.completed(),
                        r.ending(),
                        List.of(),
                        r.errors(),
                        ModuleReadings.EMPTY))
            .toList(),
        collisions,
        events,
        seconds);
  }

  /**
   * The result of one robot's search.
   *
   * @param robot its name
   * @param completed whether it completed its lanes
   * @param ending its last reported activity
   * @param samples its states, ten times a second
   * @param errors of each position estimator, by its name: root mean square, metres
   * @param readings of its modules during the search
   */
  public record RobotMissionResult(
      String robot,
      boolean completed,
      String ending,
      List<Sample> samples,
      Map<String, Double> errors,
      ModuleReadings readings) {

    public RobotMissionResult {
      samples = List.copyOf(samples);
      errors = Map.copyOf(errors);
    }
  }
}
