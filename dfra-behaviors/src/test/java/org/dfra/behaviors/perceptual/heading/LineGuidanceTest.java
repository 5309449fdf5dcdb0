package org.dfra.behaviors.perceptual.heading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Random;
import org.assertj.core.data.Offset;
import org.dfra.flow.perceptual.HeadingPercept;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.api.Test;

class LineGuidanceTest {

  private static final GeoPosition DATUM = new GeoPosition(48, 11, 0);
  private static final LineGuidance GUIDANCE = new LineGuidance(4);
  private static final LocalPosition BEGIN = new LocalPosition(0, 0, 0);
  private static final LocalPosition NORTH = new LocalPosition(0, 20, 0);
  private static final Offset<Double> NEAR = within(1e-9);

  private static PoseEstimate pose(double east, double north, double yaw) {
    return new PoseEstimate(
        Instant.EPOCH, "map", DATUM, east, north, yaw, 0, 0, 0.1, 0.03, null, null);
  }

  private static HeadingPercept towards(PoseEstimate pose, LocalPosition from, LocalPosition to) {
    return GUIDANCE.towards(pose, from, to, "base_link");
  }

  @Test
  void onTheLineAndAlongItThereIsNoError() {
    HeadingPercept seen = towards(pose(0, 5, Math.PI / 2), BEGIN, NORTH);
    assertThat(seen.headingError()).isCloseTo(0, NEAR);
    assertThat(seen.crossTrack()).isCloseTo(0, NEAR);
    assertThat(seen.alongTrack()).isCloseTo(5, NEAR);
    assertThat(seen.remainingAlongTrack()).isCloseTo(15, NEAR);
    assertThat(seen.distance()).isCloseTo(15, NEAR);
    assertThat(seen.headingSigma()).isEqualTo(0.03);
  }

  @Test
  void leftIsPositive() {
    HeadingPercept left = towards(pose(-3, 5, Math.PI / 2), BEGIN, NORTH);
    assertThat(left.crossTrack()).as("left of the line").isCloseTo(3, NEAR);
    assertThat(left.headingError())
        .as("the point 4 m on is to its right")
        .isCloseTo(-Math.atan2(3, 4), NEAR);
    HeadingPercept right = towards(pose(3, 5, Math.PI / 2), BEGIN, NORTH);
    assertThat(right.crossTrack()).isCloseTo(-3, NEAR);
    assertThat(right.headingError()).isCloseTo(Math.atan2(3, 4), NEAR);
    assertThat(towards(pose(0, 5, 0), BEGIN, NORTH).headingError())
        .as("it faces east and has to turn to the left")
        .isCloseTo(Math.PI / 2, NEAR);
  }

  @Test
  void beforeItsBeginningItHeadsForTheLineAndBeyondItsEndBack() {
    HeadingPercept before = towards(pose(0, -10, Math.PI / 2), BEGIN, NORTH);
    assertThat(before.alongTrack()).isCloseTo(-10, NEAR);
    assertThat(before.headingError()).isCloseTo(0, NEAR);
    HeadingPercept beyond = towards(pose(0, 21, Math.PI / 2), BEGIN, NORTH);
    assertThat(beyond.remainingAlongTrack()).isCloseTo(-1, NEAR);
    assertThat(beyond.distance()).isCloseTo(1, NEAR);
    assertThat(Math.abs(beyond.headingError())).isCloseTo(Math.PI, NEAR);
  }

  @Test
  void aLineOfNoLengthIsItsEndThatTheRobotComesTo() {
    LocalPosition to = new LocalPosition(0.03, 0, 0);
    HeadingPercept seen = towards(pose(-4, 3, 0), BEGIN, to);
    assertThat(seen.headingError()).isCloseTo(Math.atan2(-3, 4.03), NEAR);
    assertThat(seen.distance()).isCloseTo(Math.hypot(4.03, 3), NEAR);
    assertThat(seen.remainingAlongTrack()).isEqualTo(seen.distance());
    assertThat(seen.alongTrack()).as("it changes as the robot moves").isEqualTo(-seen.distance());
    assertThat(seen.crossTrack()).isZero();
  }

  @Test
  void steeringByTheErrorAimsAtThePointAheadOnTheLine() {
    long seed = System.nanoTime();
    Random random = new Random(seed);
    for (int i = 0; i < 10_000; i++) {
      LocalPosition from = any(random);
      LocalPosition to = any(random);
      double length = Math.hypot(to.east() - from.east(), to.north() - from.north());
      while (length < LineGuidance.POINT) { // a line of no length has a test of its own
        to = any(random);
        length = Math.hypot(to.east() - from.east(), to.north() - from.north());
      }
      PoseEstimate pose =
          pose(
              random.nextGaussian() * 20,
              random.nextGaussian() * 20,
              (random.nextDouble() - 0.5) * 6);
      double lookahead = 0.5 + random.nextDouble() * 10;
      HeadingPercept seen = new LineGuidance(lookahead).towards(pose, from, to, "base_link");
      // The foot of the robot on the line, found by search rather than by projection.
      double foot = foot(pose, from, to, length);
      double aim = Math.min(length, Math.max(0, foot) + lookahead) / length;
      double east = from.east() + aim * (to.east() - from.east()) - pose.east();
      double north = from.north() + aim * (to.north() - from.north()) - pose.north();
      double look = pose.yaw() + seen.headingError();
      double aside = (Math.cos(look) * north - Math.sin(look) * east) / Math.hypot(east, north);
      double ahead = Math.cos(look) * east + Math.sin(look) * north;
      assertThat(Math.abs(aside)).as("seed %s, line %s to %s", seed, from, to).isLessThan(1e-4);
      assertThat(ahead).as("seed %s", seed).isPositive();
      assertThat(Math.abs(seen.headingError())).as("seed %s", seed).isLessThanOrEqualTo(Math.PI);
      assertThat(Math.abs(seen.crossTrack()))
          .as("seed %s, line %s to %s", seed, from, to)
          .isCloseTo(
              Math.hypot(
                  from.east() + foot / length * (to.east() - from.east()) - pose.east(),
                  from.north() + foot / length * (to.north() - from.north()) - pose.north()),
              within(1e-4));
    }
  }

  private static LocalPosition any(Random random) {
    return new LocalPosition(random.nextGaussian() * 20, random.nextGaussian() * 20, 0);
  }

  private static double foot(
      PoseEstimate pose, LocalPosition from, LocalPosition to, double length) {
    double low = -1000;
    double high = 1000;
    for (int i = 0; i < 200; i++) {
      double a = low + (high - low) / 3;
      double b = high - (high - low) / 3;
      if (off(pose, from, to, a / length) < off(pose, from, to, b / length)) {
        high = b;
      } else {
        low = a;
      }
    }
    return (low + high) / 2;
  }

  /** Squared, in metres. */
  private static double off(PoseEstimate pose, LocalPosition from, LocalPosition to, double part) {
    double east = from.east() + part * (to.east() - from.east()) - pose.east();
    double north = from.north() + part * (to.north() - from.north()) - pose.north();
    return east * east + north * north;
  }
}
