package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.BehaviorStatus.Phase;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WaypointTextTest {

  @ParameterizedTest
  @CsvSource({
    "waypoint 2 of 3: it turns, 1, 3, waypoint 7 of 8: it turns",
    "it waits: no position, 1, 3, it waits: no position",
    "Punkt 2 von 3, 1, 3, Punkt 2 von 3", // another's path, with words of its own
    "waypoint 2 of 3: it turns, 0, 0, waypoint 2 of 3: it turns", // an older one, not counted
    "waypoint 2 of 30: it turns, 1, 3, waypoint 2 of 30: it turns", // neither are these its numbers
  })
  void countsAmongAllByTheNumbersAndNotByTheWords(
      String doing, int done, int parts, String expected) {
    BehaviorStatus path =
        new BehaviorStatus(Instant.EPOCH, null, Phase.RUNNING, doing, 0, 0, null, done, parts);
    assertThat(WaypointText.positionInWhole(path, 5, 8)).isEqualTo(expected);
  }
}
