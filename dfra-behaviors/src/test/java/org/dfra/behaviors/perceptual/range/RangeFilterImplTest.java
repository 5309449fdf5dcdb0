package org.dfra.behaviors.perceptual.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Arrays;
import java.util.Map;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.ScriptedSensors.Laser;
import org.dfra.behaviors.ScriptedSensors.Wheels;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The module around filter, clearance and memory, on a computer whose clock is set. */
@Timeout(60)
class RangeFilterImplTest {

  private static final int BEAMS = 181;
  private static final double GAP = 0.7 - 0.32; // metres, from the robot's side to the obstacle

  private final ScriptedRobot robot = new ScriptedRobot();
  private final Wheels wheels = robot.add(new Wheels(robot.context("odometry", Map.of())));
  private final Laser laser = robot.add(new Laser(robot.context("laser", Map.of())));
  private final RangeFilterImpl filter =
      robot.add(
          new RangeFilterImpl(
              robot.context("filter", Map.of("median_scans", "1", "obstacle_memory", "3"))));

  @AfterEach
  void end() {
    robot.close();
  }

  /**
   * Stands for so long where it has driven to, and scans an obstacle that is so far to the left.
   */
  private void scan(double seconds, double metres, double left) {
    float[] ranges = new float[BEAMS];
    Arrays.fill(ranges, Float.POSITIVE_INFINITY);
    ranges[BEAMS - 1] = (float) left;
    for (int i = 0; i < Math.round(seconds * 10); i++) {
      robot.time.step(0.1);
      wheels.count(metres, 0);
      laser.scan(ranges);
    }
    robot.time.step(0);
  }

  @ParameterizedTest
  @ValueSource(longs = {-100, 0, 100})
  void remembersAPassedObstacleForTheSameTimeWhereTheClockIsSet(long seconds) {
    scan(0.5, 0, 0.7);
    assertThat(filter.clearance().left()).as("seen").isCloseTo(GAP, within(0.03));
    scan(0.5, 0.4, Double.POSITIVE_INFINITY);
    assertThat(filter.clearance().left()).as("passed").isCloseTo(GAP, within(0.03));
    for (String module : new String[] {"odometry", "laser", "filter"}) {
      robot.setAhead(module, Duration.ofSeconds(seconds));
    }
    scan(2, 0.4, Double.POSITIVE_INFINITY);
    assertThat(filter.clearance().left()).as("2.5 s later").isCloseTo(GAP, within(0.03));
    scan(1, 0.4, Double.POSITIVE_INFINITY);
    assertThat(filter.clearance().left()).as("3.5 s later").isEqualTo(8);
  }
}
