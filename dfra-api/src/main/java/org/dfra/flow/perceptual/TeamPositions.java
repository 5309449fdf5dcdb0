package org.dfra.flow.perceptual;

import java.time.Instant;
import java.util.List;

/**
 * What a robot knows of the others of its team.
 *
 * @param measured time of the newest of its own poses that it rests on, by its own clock, UTC
 * @param frame name of the frame of that pose, whose east and north are meant, e.g. {@code
 *     atrv1/map}
 * @param teammates every other robot that was ever heard of, by name
 */
public record TeamPositions(Instant measured, String frame, List<Teammate> teammates)
    implements Percept {

  public TeamPositions {
    teammates = List.copyOf(teammates);
  }
}
