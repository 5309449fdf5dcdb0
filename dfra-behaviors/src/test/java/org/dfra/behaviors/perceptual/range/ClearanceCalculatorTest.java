package org.dfra.behaviors.perceptual.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import org.assertj.core.data.Offset;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.Transform;
import org.junit.jupiter.api.Test;

/** A body of 0.8 m by 0.6 m; its laser 0.3 m ahead of its middle. */
class ClearanceCalculatorTest {

  private static final ClearanceCalculator SURROUNDS = new ClearanceCalculator(0.4, 0.3, 8);
  private static final Transform FRONT = Transform.of(0.3, 0, 0.35, 0, 0, 0);
  private static final Offset<Double> NEAR = within(1e-6);
  private static final double STEP = Math.PI / 180;

  private static Clearance of(Transform mount, double firstAngle, float... ranges) {
    RangeScan scan = new RangeScan(Instant.EPOCH, "laser", firstAngle, STEP, 0, 0, 80, ranges);
    return SURROUNDS.clearance(scan, ranges, mount, SURROUNDS.new SideClearance(), "base_link");
  }

  /** One beam at an angle, the end of which is at a place in the body's frame. */
  private static Clearance point(double x, double y) {
    return of(FRONT, Math.atan2(y, x - 0.3), (float) Math.hypot(x - 0.3, y));
  }

  @Test
  void nothingIsAtItsReach() {
    Clearance none = of(FRONT, 0, Float.POSITIVE_INFINITY, Float.NaN, 79);
    assertThat(none.left()).isEqualTo(8);
    assertThat(none.centre()).isEqualTo(8);
    assertThat(none.right()).isEqualTo(8);
  }

  @Test
  void whatMayHaveComeNearerCountsAsNearerWhereSomethingIsSeen() {
    Clearance seen = new Clearance(Instant.EPOCH, "base_link", 0.2, 2, 8);
    assertThat(SURROUNDS.reducedBy(seen, 0.5))
        .as("nothing is seen to the right")
        .isEqualTo(new Clearance(Instant.EPOCH, "base_link", 0, 1.5, 8));
  }

  @Test
  void aheadCountsFromTheBumper() {
    Clearance seen = point(2.4, 0);
    assertThat(seen.centre()).isCloseTo(2, NEAR);
    assertThat(seen.left()).isEqualTo(8);
    assertThat(seen.right()).isEqualTo(8);
    assertThat(point(1.4, 0.74).centre()).as("in the corridor").isCloseTo(1, NEAR);
    assertThat(point(1.4, -0.74).centre()).isCloseTo(1, NEAR);
    assertThat(point(1.4, 0.76).centre()).as("beside it").isEqualTo(8);
    assertThat(point(6.4, 1.5).centre()).as("within 15° of ahead").isCloseTo(6, NEAR);
    assertThat(point(6.4, 2).centre()).isEqualTo(8);
  }

  @Test
  void sidesCountFromTheBody() {
    Clearance left = point(0.3, 1.3);
    assertThat(left.left()).isCloseTo(1, NEAR);
    assertThat(left.right()).isEqualTo(8);
    assertThat(left.centre()).isEqualTo(8);
    Clearance right = point(0.7, -0.7); // 0.3 m ahead of the corner, 0.4 m beside it
    assertThat(right.right()).isCloseTo(0.5, NEAR);
    assertThat(right.left()).isEqualTo(8);
  }

  @Test
  void aRoomIsMeasuredOnAllSides() {
    float[] ranges = new float[181];
    for (int i = 0; i < ranges.length; i++) {
      double angle = (i - 90) * STEP;
      double ahead = Math.cos(angle) > 1e-9 ? 2.1 / Math.cos(angle) : Double.MAX_VALUE;
      double aside = Math.sin(angle) > 1e-9 ? 1.8 / Math.sin(angle) : -1.3 / Math.sin(angle);
      ranges[i] = (float) Math.min(ahead, i == 90 ? ahead : aside);
    }
    Clearance clearance = of(FRONT, -Math.PI / 2, ranges); // walls 2.4 ahead, 1.8 left, 1.3 right
    assertThat(clearance.centre()).isCloseTo(2, NEAR);
    assertThat(clearance.left()).isCloseTo(1.5, NEAR);
    assertThat(clearance.right()).isCloseTo(1, NEAR);
    assertThat(clearance.min()).isCloseTo(1, NEAR);
  }

  @Test
  void aSensorMayBeTurnedAndShifted() {
    Transform toTheLeft = Transform.of(0, 0.3, 0, 0, 0, Math.PI / 2);
    Clearance seen = of(toTheLeft, 0, 1);
    assertThat(seen.left()).isCloseTo(1, NEAR);
    assertThat(seen.centre()).isEqualTo(8);
    Transform backwards = Transform.of(-0.4, 0, 0, 0, 0, Math.PI);
    assertThat(of(backwards, Math.PI - 0.001, 2.8f).centre())
        .as("what it sees over its shoulder, 2 m ahead of the bumper")
        .isCloseTo(2, within(1e-5));
    assertThat(of(backwards, 0, 1).centre()).as("what is behind").isEqualTo(8);
  }

  @Test
  void whatWasPassedCountsBesideTheBodyOnly() {
    ClearanceCalculator.SideClearance passed = SURROUNDS.new SideClearance();
    passed.accept(-0.2, 0.7); // 0.4 m from its left flank
    passed.accept(-0.8, -0.3); // 0.4 m behind its right corner
    RangeScan scan = new RangeScan(Instant.EPOCH, "laser", 0, STEP, 0, 0, 80, new float[] {79});
    Clearance seen = SURROUNDS.clearance(scan, scan.ranges(), FRONT, passed, "base_link");
    assertThat(seen.left()).isCloseTo(0.4, NEAR);
    assertThat(seen.right()).isCloseTo(0.4, NEAR);
    assertThat(seen.centre()).isEqualTo(8);
  }

  @Test
  void whatIsTooNearToBeMeasuredIsAtTheSensor() {
    assertThat(of(FRONT, 0, Float.NEGATIVE_INFINITY).centre()).isZero();
  }

  @Test
  void aScanSaysNothingWhereMoreThanAQuarterFailed() {
    float[] ranges = new float[100];
    Arrays.fill(ranges, 0, 25, Float.NaN);
    assertThat(ClearanceCalculator.hasEnoughBeams(ranges)).isTrue();
    ranges[25] = Float.NaN;
    assertThat(ClearanceCalculator.hasEnoughBeams(ranges)).isFalse();
    assertThat(ClearanceCalculator.hasEnoughBeams(new float[0])).isFalse();
  }
}
