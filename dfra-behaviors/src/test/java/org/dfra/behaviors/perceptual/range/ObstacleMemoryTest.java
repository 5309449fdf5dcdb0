package org.dfra.behaviors.perceptual.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.Transform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A laser at the front of a robot that sees the half circle ahead, a beam a degree. */
class ObstacleMemoryTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Transform MOUNT = Transform.translation(0.3, 0, 0);
  private static final int BEAMS = 181;

  /** By how much the computer's clock was set, seconds. */
  private double clockStep;

  private final ObstacleMemory passed = new ObstacleMemory(Duration.ofSeconds(3));

  /** A scan that detects a thing at a place of the odometry's frame, if it is in view. */
  private void scan(double seconds, double x, double y, double yaw, double thingX, double thingY) {
    Odometry at = odometry(seconds + clockStep, x, y, yaw);
    double forward = Math.cos(yaw) * (thingX - x) + Math.sin(yaw) * (thingY - y) - MOUNT.x();
    double left = Math.cos(yaw) * (thingY - y) - Math.sin(yaw) * (thingX - x);
    float[] ranges = new float[BEAMS];
    Arrays.fill(ranges, Float.POSITIVE_INFINITY);
    int beam = (int) Math.rint(Math.toDegrees(Math.atan2(left, forward)) + 90);
    if (beam >= 0 && beam < BEAMS) {
      ranges[beam] = (float) Math.hypot(forward, left);
    }
    RangeScan scan =
        new RangeScan(at.measured(), "laser", -Math.PI / 2, Math.toRadians(1), 0, 0.02, 80, ranges);
    passed.take(scan, ranges, MOUNT, at, nanos(seconds));
  }

  private static Odometry odometry(double seconds, double x, double y, double yaw) {
    Instant time = BEGIN.plusNanos(nanos(seconds));
    return new Odometry(time, "odom", "base_link", x, y, yaw, 0, 0);
  }

  private static long nanos(double seconds) {
    return Math.round(seconds * 1e9);
  }

  private List<double[]> remembered(double x, double y, double yaw) {
    List<double[]> points = new ArrayList<>();
    passed.forEach(
        odometry(0, x, y, yaw), (forward, left) -> points.add(new double[] {forward, left}));
    return points;
  }

  @Test
  void remembersWhereAThingIsThatItHasDrivenPast() {
    for (int i = 0; i <= 15; i++) {
      scan(i * 0.1, i * 0.1, 0, 0, 1, 0.7);
    }
    List<double[]> points = remembered(1.5, 0, 0);
    assertThat(points).isNotEmpty();
    for (double[] each : points) {
      assertThat(each[0]).as("behind the middle, metres").isCloseTo(-0.5, within(0.06));
      assertThat(each[1]).as("to the left, metres").isCloseTo(0.7, within(0.06));
    }
    double[] turned = remembered(1.5, 0, Math.PI / 2).get(0);
    assertThat(turned[0]).as("ahead once it has turned left").isCloseTo(0.7, within(0.06));
    assertThat(turned[1]).isCloseTo(0.5, within(0.06));
  }

  @Test
  void takesTheSensorsWordForWhatTheSensorSees() {
    scan(0, 0, 0, 0, 1, 0.7);
    assertThat(remembered(0, 0, 0)).hasSize(1);
    scan(0.1, 0, 0, 0, 9, 9); // it was carried away
    assertThat(remembered(0, 0, 0)).isEmpty();
  }

  @Test
  void forgetsAfterAWhileAndAtADistance() {
    scan(0, 0, 0, 0, 1, 0.7);
    scan(1, 1.5, 0, 0, 1, 0.7); // out of sight
    assertThat(remembered(1.5, 0, 0)).hasSize(1);
    scan(2.9, 1.5, 0, 0, 1, 0.7);
    assertThat(remembered(1.5, 0, 0)).hasSize(1);
    scan(3.1, 1.5, 0, 0, 1, 0.7);
    assertThat(remembered(1.5, 0, 0)).as("3 s are over").isEmpty();

    scan(4, 0, 0, 0, 1, 0.7);
    scan(5, 3.2, 0, 0, 1, 0.7);
    assertThat(remembered(3.2, 0, 0)).as("farther than 2 m").isEmpty();
  }

  /** A receiver's first fix sets the clock of a robot that is driving, say. */
  @ParameterizedTest
  @ValueSource(doubles = {-100, 100})
  void remembersForTheSameTimeWhereTheClockIsSet(double step) {
    scan(0, 0, 0, 0, 1, 0.7);
    scan(1, 1.5, 0, 0, 1, 0.7); // out of sight
    clockStep = step;
    scan(1.1, 1.5, 0, 0, 1, 0.7);
    assertThat(remembered(1.5, 0, 0)).as("passed 1.1 s ago").hasSize(1);
    scan(2.9, 1.5, 0, 0, 1, 0.7);
    assertThat(remembered(1.5, 0, 0)).as("passed 2.9 s ago").hasSize(1);
    scan(3.1, 1.5, 0, 0, 1, 0.7);
    assertThat(remembered(1.5, 0, 0)).as("3 s are over").isEmpty();
  }

  @Test
  void passesOverBeamsThatMeasuredNothingOrFailed() {
    float[] ranges = new float[BEAMS];
    Arrays.fill(ranges, Float.NaN);
    ranges[3] = Float.POSITIVE_INFINITY;
    ranges[4] = Float.NEGATIVE_INFINITY;
    RangeScan scan =
        new RangeScan(BEGIN, "laser", -Math.PI / 2, Math.toRadians(1), 0, 0.02, 80, ranges);
    passed.take(scan, ranges, MOUNT, odometry(0, 0, 0, 0), 0);
    assertThat(remembered(0, 0, 0)).isEmpty();
  }
}
