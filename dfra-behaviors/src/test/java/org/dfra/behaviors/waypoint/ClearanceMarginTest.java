package org.dfra.behaviors.waypoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import org.assertj.core.data.Offset;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.perceptual.Clearance;
import org.junit.jupiter.api.Test;

class ClearanceMarginTest {

  private static final double PEER = 0.7;
  private static final Offset<Double> NEAR = within(1e-9);

  private final ClearanceMargin margin = new ClearanceMargin(PEER);
  private long nanos = 5_000_000_000L;

  private Clearance seen(double age) {
    Instant measured = Instant.EPOCH;
    return margin.reduced(
        new Clearance(measured, "atrv1/base_link", 1, 4, 2),
        measured.plus(Duration.ofMillis(Math.round(age * 1000))),
        nanos);
  }

  private void drive(double speed) {
    margin.recordCommand(new Velocity(speed, 0), nanos);
  }

  private void pass(double seconds) {
    nanos += Math.round(seconds * 1e9);
  }

  @Test
  void takesNothingOffWhatComesInTime() {
    for (int i = 0; i < 20; i++) {
      Clearance now = seen(0.1);
      assertThat(now.centre()).isCloseTo(4, NEAR);
      assertThat(now.left()).isCloseTo(1, NEAR);
      assertThat(now.right()).isCloseTo(2, NEAR);
      drive(0.7);
      pass(0.1);
    }
    assertThat(seen(-3).centre()).as("a clock that is behind").isCloseTo(4, NEAR);
  }

  @Test
  void takesOffWhatBothCanComeNearerWhileTheClearanceIsOld() {
    drive(0.5);
    Clearance late = seen(0.6); // 0.5 s more than usual
    assertThat(late.centre()).isCloseTo(4 - 0.5 * (0.5 + PEER), NEAR);
    assertThat(late.left()).isCloseTo(1 - 0.5 * PEER, NEAR);
    assertThat(late.right()).isCloseTo(2 - 0.5 * PEER, NEAR);
    assertThat(late.measured()).isEqualTo(Instant.EPOCH);
  }

  @Test
  void takesOffWhatALateCycleCostsAsFarAsTheWheelsGoOn() {
    Clearance first = seen(0.1);
    assertThat(first.centre()).isCloseTo(4, NEAR);
    pass(0.25);
    assertThat(seen(0.1).right()).as("0.15 s later than usual").isCloseTo(2 - 0.15 * PEER, NEAR);
    pass(7);
    assertThat(seen(0.1).right()).as("wheels stop after 0.3 s").isCloseTo(2 - 0.2 * PEER, NEAR);
    pass(0.1);
    assertThat(seen(0.1).right()).as("in time again").isCloseTo(2, NEAR);
    margin.reset();
    pass(7);
    assertThat(seen(0.1).right()).as("a pause is no cycle").isCloseTo(2, NEAR);
  }

  @Test
  void aRobotThatHasJustStoppedStillCountsAsOneThatDrove() {
    drive(0.7);
    pass(0.1);
    drive(0);
    assertThat(seen(0.6).centre()).isCloseTo(4 - 0.5 * (0.7 + PEER), NEAR);
    pass(1);
    drive(-0.2);
    margin.reset();
    assertThat(seen(0.6).centre()).as("backwards is not nearer").isCloseTo(4 - 0.5 * PEER, NEAR);
  }

  @Test
  void anOffClockTakesOffNoMoreThanASecondAndNothingBecomesNegative() {
    Clearance late = seen(3600);
    assertThat(late.centre()).isCloseTo(4 - PEER, NEAR);
    assertThat(late.left()).isCloseTo(1 - PEER, NEAR);
    drive(5);
    assertThat(seen(3600).centre()).isZero();
  }
}
