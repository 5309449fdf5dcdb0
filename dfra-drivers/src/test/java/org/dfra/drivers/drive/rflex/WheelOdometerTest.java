package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WheelOdometerTest {

  private static final double PER_METRE = 100_000;
  private static final double PER_RADIAN = 40_000;

  private final WheelOdometer count = new WheelOdometer(PER_METRE, PER_RADIAN, 1, 2);
  private long timestamp = 1000;

  private boolean report(Axis axis, double at) {
    double perUnit = axis == Axis.TRANSLATION ? PER_METRE : PER_RADIAN;
    return report(axis, (int) Math.round(at * perUnit));
  }

  private boolean report(Axis axis, int position) {
    return count.update(new MotorReport(timestamp, axis, position, 4000, 0, 0));
  }

  /** Both axes at one moment. */
  private void report(double along, double about) {
    timestamp += 100;
    report(Axis.TRANSLATION, along);
    report(Axis.ROTATION, about);
  }

  @Test
  void beginsWhereItIsWhereverTheControllersCountIs() {
    report(17, 5);
    assertThat(count.x()).isZero();
    assertThat(count.y()).isZero();
    assertThat(count.yaw()).isZero();
    report(17.5, 5);
    assertThat(count.x()).isCloseTo(0.5, within(1e-12));
    assertThat(count.speed()).isEqualTo(0.04);
    assertThat(count.yawRate()).isEqualTo(0.1);
  }

  /** A circle of 2 m: exact, however long the steps, since each is an arc. */
  @ParameterizedTest
  @ValueSource(ints = {5, 10, 100, 1000})
  void goesRoundACircleToTheLeft(int steps) {
    report(0, 0);
    for (int i = 1; i <= steps; i++) {
      double turned = 2 * Math.PI * i / steps;
      report(2 * turned, turned);
      // Each count is rounded, to 5 µm and 12.5 µrad.
      assertThat(count.x()).isCloseTo(2 * Math.sin(turned), within(1e-4));
      assertThat(count.y()).isCloseTo(2 * (1 - Math.cos(turned)), within(1e-4));
    }
    assertThat(count.yaw()).as("not wrapped").isCloseTo(2 * Math.PI, within(1e-4));
  }

  @Test
  void goesBackToTheRight() {
    report(0, 0);
    report(-1, -Math.PI / 2);
    // Backwards on an arc of a quarter, radius 2/π, which bends to the left of where it goes.
    assertThat(count.x()).isCloseTo(-2 / Math.PI, within(1e-4));
    assertThat(count.y()).isCloseTo(2 / Math.PI, within(1e-4));
  }

  @Test
  void aLostReportIsMadeGoodByTheNext() {
    report(0, 0);
    report(1, 0);
    timestamp += 100;
    assertThat(report(Axis.TRANSLATION, 1.5)).isFalse(); // the other axis' is lost
    timestamp += 100;
    assertThat(report(Axis.TRANSLATION, 2.0)).isTrue();
    assertThat(report(Axis.ROTATION, 0.0)).isTrue();
    assertThat(count.x()).isCloseTo(2, within(1e-9));
    timestamp += 100;
    assertThat(report(Axis.ROTATION, 0.0)).as("in another order").isFalse();
    assertThat(report(Axis.TRANSLATION, 2.5)).isTrue();
    assertThat(count.x()).isCloseTo(2.5, within(1e-9));
    assertThat(count.restarts()).isZero();
  }

  @Test
  void countsOnWhereItWrapsAround() {
    report(Axis.TRANSLATION, Integer.MAX_VALUE - 1000);
    report(Axis.ROTATION, Integer.MIN_VALUE + 1000);
    timestamp += 100;
    report(Axis.TRANSLATION, Integer.MIN_VALUE + 999); // 2000 counts on
    report(Axis.ROTATION, Integer.MIN_VALUE + 1000);
    assertThat(count.x()).isCloseTo(0.02, within(1e-12));
    timestamp += 100;
    report(Axis.TRANSLATION, Integer.MAX_VALUE - 1000); // and back
    report(Axis.ROTATION, Integer.MIN_VALUE + 1000);
    assertThat(count.x()).isCloseTo(0, within(1e-12));
    assertThat(count.restarts()).isZero();
  }

  @Test
  void aClockThatWrapsAroundIsNoRestart() {
    timestamp = 0xFFFF_FFF0L;
    report(Axis.TRANSLATION, 0.0);
    report(Axis.ROTATION, 0.0);
    timestamp = 20;
    report(Axis.TRANSLATION, 0.1);
    report(Axis.ROTATION, 0.0);
    assertThat(count.x()).isCloseTo(0.1, within(1e-9));
    assertThat(count.restarts()).isZero();
  }

  @Test
  void aClockThatGoesBackIsARestartAndNoMotion() {
    report(0.0, 0.0);
    report(1.0, 0.5);
    timestamp = 0;
    report(0, 0);
    assertThat(count.x()).isCloseTo(Math.sin(0.5) / 0.5, within(1e-4));
    assertThat(count.yaw()).isCloseTo(0.5, within(1e-4));
    assertThat(count.restarts()).isEqualTo(2);
    report(0, 0.5);
    assertThat(count.yaw()).isCloseTo(1, within(1e-4));
  }

  @Test
  void aJumpThatNoWheelCanMakeIsARestart() {
    report(50, 0);
    report(0, 0);
    assertThat(count.x()).isZero();
    assertThat(count.restarts()).isEqualTo(1);
    report(2.9, 0);
    assertThat(count.x()).as("a second or three of a lost link").isCloseTo(2.9, within(1e-9));
  }

  @Test
  void aCountOfZeroAfterAGapIsARestartAndAnyOtherIsMotion() {
    report(2, 1);
    count.linkInterrupted();
    report(0, 0);
    assertThat(count.x()).isZero();
    assertThat(count.restarts()).isEqualTo(2);
    report(0.5, 0);
    count.linkInterrupted();
    report(0.7, 0);
    assertThat(count.x()).isCloseTo(0.7, within(1e-9));
    report(0, 0);
    assertThat(count.x()).as("without a gap it went there").isCloseTo(0, within(1e-9));
  }

  @Test
  void countsBackwardsWhereTheControllerDoes() {
    WheelOdometer mirrored = new WheelOdometer(-PER_METRE, -PER_RADIAN, 1, 2);
    mirrored.update(new MotorReport(1, Axis.TRANSLATION, 0, 0, 0, 0));
    mirrored.update(new MotorReport(1, Axis.ROTATION, 0, 0, 0, 0));
    mirrored.update(new MotorReport(2, Axis.TRANSLATION, -100_000, -50_000, 0, 0));
    mirrored.update(new MotorReport(2, Axis.ROTATION, -4000, 0, 0, 0));
    assertThat(mirrored.x()).isPositive();
    assertThat(mirrored.yaw()).isCloseTo(0.1, within(1e-12));
    assertThat(mirrored.speed()).isEqualTo(0.5);
  }
}
