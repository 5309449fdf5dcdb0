package org.dfra.app.raster;

import java.util.List;
import java.util.Map;
import org.dfra.sim.world.Collision;

/**
 * What became of a search.
 *
 * @param robots one for each robot
 * @param collisions all of them
 * @param events what happened on the way, collisions included, in the order in which it did
 * @param seconds that it took, by the robots' time
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

  /** The same without what is large. */
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
   * What became of one robot's search.
   *
   * @param robot its name
   * @param completed whether it came to the end of its lanes
   * @param ending what it said at last
   * @param samples where it was, ten times a second
   * @param errors of each position estimator, by its name: root mean square, metres
   * @param readings what its modules told meanwhile
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
