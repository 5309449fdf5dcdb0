package org.dfra.app.raster;

import java.util.List;
import java.util.Map;
import org.dfra.sim.world.Collision;

/**
 * What became of a search.
 *
 * @param robots one for each robot
 * @param collisions all of them
 * @param marks what happened on the way, collisions included, in the order in which it did
 * @param seconds that it took, by the robots' time
 */
public record Flight(
    List<RobotFlight> robots, List<Collision> collisions, List<Mark> marks, double seconds) {

  public Flight {
    robots = List.copyOf(robots);
    collisions = List.copyOf(collisions);
    marks = List.copyOf(marks);
  }

  /** The same without what is large. */
  public Flight withoutSamples() {
    return new Flight(
        robots.stream()
            .map(
                r ->
                    new RobotFlight(
                        r.robot(),
                        r.completed(),
                        r.ending(),
                        List.of(),
                        r.errors(),
                        Overheard.NOTHING))
            .toList(),
        collisions,
        marks,
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
   * @param overheard what its modules told meanwhile
   */
  public record RobotFlight(
      String robot,
      boolean completed,
      String ending,
      List<Sample> samples,
      Map<String, Double> errors,
      Overheard overheard) {

    public RobotFlight {
      samples = List.copyOf(samples);
      errors = Map.copyOf(errors);
    }
  }
}
