package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dfra.flow.perceptual.HeadingPercept;
import org.junit.jupiter.api.Test;

class StuckDetectorTest {

  private final StuckDetector watch = new StuckDetector(6, 40);

  private boolean look(double seconds, double along, double error) {
    return watch.isStuck(
        Math.round(seconds * 1e9),
        new HeadingPercept(
            Instant.EPOCH, "base_link", error, 0, 0, along, 100 - along, 100 - along));
  }

  @Test
  void aRobotThatStaysInPlaceForSixSecondsIsStuck() {
    for (double t = 0; t <= 6; t += 0.1) {
      assertThat(look(t, 0.1, 0)).as("%s s", t).isFalse();
    }
    assertThat(look(6.2, 0.1, 0)).isTrue();
    watch.reset();
    assertThat(look(6.3, 0.1, 0)).isFalse();
  }

  @Test
  void aRobotThatCreepsOnOrRotatesIsNotStuck() {
    for (double t = 0; t < 30; t += 0.1) {
      assertThat(look(t, t * 0.1, 0)).as("creeps, %s s", t).isFalse();
    }
    watch.reset();
    for (double t = 0; t < 30; t += 0.1) {
      assertThat(look(t, 0, Math.IEEEremainder(t * 0.3, 2 * Math.PI)))
          .as("turns, %s s", t)
          .isFalse();
    }
  }

  @Test
  void aRobotThatMovesAndComesNoNearerIsStuckAfterFortySeconds() {
    boolean isStuck = false;
    double t = 0;
    while (!isStuck && t < 60) {
      t += 0.1;
      isStuck = look(t, Math.sin(t), 0);
    }
    assertThat(t).isBetween(39.0, 45.0);
  }

  @Test
  void aTurnThatWasHeldUpSaysNothing() {
    assertThat(look(0, 0, 0)).isFalse();
    assertThat(look(7, 5, 0)).as("it was not watched for 7 s").isFalse();
    assertThat(look(7.1, 5, 0)).isFalse();
  }
}
