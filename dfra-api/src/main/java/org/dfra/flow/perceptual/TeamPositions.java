package org.dfra.flow.perceptual;

import java.time.Instant;
import java.util.List;

/**
 * The positions of a robot's teammates, as far as it knows them.
 *
 * @param measured time of the robot's newest own pose that it is based on, by its own clock, UTC
 * @param frame name of that pose's frame, which defines east and north, e.g. {@code atrv1/map}
 * @param teammates every other robot that has ever sent a message, by name
 */
public record TeamPositions(Instant measured, String frame, List<Teammate> teammates)
    implements Percept {

  public TeamPositions {
    teammates = List.copyOf(teammates);
  }
}
